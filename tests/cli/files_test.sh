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
