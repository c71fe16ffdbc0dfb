#!/usr/bin/env bash
# Files that cannot be read or written: one sentence each, nothing lost, nothing half written.
. "$(dirname "$0")/common.sh"
plan=(--methods rk4 --problems oscillator --no-timing --no-stability -q)

run run "${plan[@]}" -o "$work/good"
expect_code 0
results="$work/good/results.jsonl"

# of another schema, and garbage, at a line that is named
mkdir "$work/other" "$work/garbage" "$work/empty"
sed '1s/"schema":1/"schema":99/' "$results" >"$work/other/results.jsonl"
sed '3s/.*/this is no row/' "$results" >"$work/garbage/results.jsonl"
: >"$work/empty/results.jsonl"
for folder in other garbage empty; do cp -r "$work/$folder" "$work/$folder.kept"; done
refused 2 'schema 99, this odemark reads schema 1' run "${plan[@]}" -o "$work/other" --resume
refused 2 'results.jsonl:3: not a results line' run "${plan[@]}" -o "$work/garbage" --resume
refused 2 'empty, not a results file' run "${plan[@]}" -o "$work/empty" --resume
for folder in other garbage empty; do
  cmp -s "$work/$folder/results.jsonl" "$work/$folder.kept/results.jsonl" || fail "a refused file was changed: $folder"
done

refused 2 'cannot read' report -o "$work/nowhere"
refused 2 'schema 99' report -o "$work/other"
refused 2 'not a results line' report -o "$work/garbage"
mkdir -p "$work/blocked/report.html" && cp "$results" "$work/blocked"
refused 2 'report.html: it is a folder' report -o "$work/blocked"
refused 2 'cannot read' compare "$results" "$work/nowhere.jsonl"

# a gate that says nothing is none: damaged, missing where it was named, rules for nothing
unset CI  # approve refuses there
printf 'schema = 1\n[[rule]]\ncase = "*/rk4"\norder = "claimed"\n' >"$work/rules.toml"
gate=(check -o "$work/good" --thresholds "$work/rules.toml")
cd "$work" || exit 1  # where no baseline.json is
run "${gate[@]}"
expect_code 0
expect_output 'there is no baseline.json'
printf '{' >baseline.json
refused 2 'baseline.json: cut or damaged' "${gate[@]}"
refused 2 'cut or damaged' approve -o good --reason test --force --only rk4
[ "$(cat baseline.json)" = '{' ] || fail "a refused approval changed the baseline"
rm baseline.json
printf '{' >"$work/damaged.json"
refused 2 'damaged.json: cut or damaged' "${gate[@]}" --baseline "$work/damaged.json"
refused 2 'there is no ' "${gate[@]}" --baseline "$work/nowhere.json"
refused 2 '--force writes a new one over it' approve -o "$work/good" --baseline "$work/damaged.json" --reason test
[ "$(cat "$work/damaged.json")" = '{' ] || fail "a refused approval changed the baseline"
run approve -o "$work/good" --baseline "$work/damaged.json" --reason test --force -q
expect_code 0
run "${gate[@]}" --baseline "$work/damaged.json"
expect_code 0
expect_output '0 failed, '
printf '[[rule]]\ncase = "lorenz*/*"\norder = "claimed"\n' >>"$work/rules.toml"
run "${gate[@]}"
expect_code 3
expect_output "$work/rules.toml:5"
expect_output 'say optional = true in the rule'
sed '$a optional = true' "$work/rules.toml" >"$work/optional.toml"
run check -o "$work/good" --thresholds "$work/optional.toml"
expect_code 0
printf 'schema = 1\n' >"$work/nothing.toml"
run check -o "$work/good" --thresholds "$work/nothing.toml"
expect_code 3
expect_output 'compared 0 of 1 cases'
expect_output 'nothing was compared'
expect_output '0 failed, 0 passed, 1 note  exit 3'

# what is to be written is asked before anything is said
for what in junit markdown json; do
  refused 2 "cannot write $work/nowhere/x" "${gate[@]}" --$what "$work/nowhere/x"
  refused 2 "cannot write $work/good: Is a directory" "${gate[@]}" --$what "$work/good"
done
refused 2 "cannot write $work/nowhere/x" approve -o "$work/good" --baseline "$work/nowhere/x" --reason test

# side by side: folders or files, limits too, and a cut one is told
run run --methods rk4 --problems oscillator --no-timing -q -o "$work/limits"
expect_code 0
run compare "$work/limits" "$work/good"
expect_code 0
expect_quiet_stderr
expect_output 'stability/oscillator/rk4/double'
expect_output '0 regressed, '
head -c -3 "$work/limits/results.jsonl" >"$work/cut.jsonl"
run compare "$work/limits/results.jsonl" "$work/cut.jsonl"
expect_code 0
expect_error "the last line of $work/cut.jsonl is cut"

# a folder that cannot be: below a file
: >"$work/file"
refused 2 'cannot write into' run "${plan[@]}" -o "$work/file/below"
if [ "$(id -u)" != 0 ]; then
  mkdir -m 555 "$work/closed"
  refused 2 'cannot write into' run "${plan[@]}" -o "$work/closed"
fi

# a disk that is full after two or three kilobytes: the limit on file sizes fails the same way
mkdir "$work/full"
(
  trap '' XFSZ
  ulimit -f 3
  exec "$ODEMARK" run "${plan[@]}" -o "$work/full"
) >"$work/out" 2>"$work/err"
code=$?
said="odemark run on a full disk"
expect_code 4
expect_one_sentence
expect_error "cannot write $work/full/results.jsonl"
expect_error 'the rows before this are kept, --resume goes on from there'
expect_quiet_stdout
run run "${plan[@]}" -o "$work/full" --resume
expect_code 0
cmp -s <(tail -n +2 "$results") <(tail -n +2 "$work/full/results.jsonl") || fail "resumed after a full disk: other rows"

# a full disk behind stdout
if [ -e /dev/full ]; then
  "$ODEMARK" list --format json >/dev/full 2>"$work/err" && fail "a full disk behind stdout is not noticed"
fi
finish
