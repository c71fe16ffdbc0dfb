#!/usr/bin/env bash
# `odemark run`: what it prints where, what it keeps, and that going on gives the bytes that going through gives.
. "$(dirname "$0")/common.sh"
plan=(--methods rk4,heun,tsitouras54 --problems oscillator,damped_spring --no-timing --no-stability --progress none)

# the header has the date; the rows must be the same bytes
rows() { tail -n +2 "$1/results.jsonl"; }
same_rows() { cmp -s <(rows "$1") <(rows "$2") || fail "$3"; }

run run "${plan[@]}" -o "$work/a"
expect_code 0
expect_output "wrote $work/a/results.jsonl"
total=$(rows "$work/a" | wc -l)
[ "$total" -gt 40 ] || fail "only $total rows"
[ "$(rows "$work/a" | sort | uniq -d | wc -l)" = 0 ] || fail "a row is there twice"
head -1 "$work/a/results.jsonl" | grep -q '"record":"header"' || fail "the first line is no header"

run run "${plan[@]}" -o "$work/b" -q -j 2
expect_code 0
expect_quiet_stderr
[ "$(wc -l <"$work/out")" = 1 ] || fail "quiet is more than one line: $(cat "$work/out")"
same_rows "$work/a" "$work/b" "two threads give other rows"

# cut in the middle of a line, as a crash would
mkdir "$work/c"
size=$(wc -c <"$work/a/results.jsonl")
for part in 2 3 4; do
  head -c $((size * part / 5)) "$work/a/results.jsonl" >"$work/c/results.jsonl"
  run run "${plan[@]}" -o "$work/c" -q --resume
  expect_code 0
  cmp -s "$work/a/results.jsonl" "$work/c/results.jsonl" || fail "resuming after a cut at $part/5 gives another file"
done
run run "${plan[@]}" -o "$work/c" -q --resume
expect_code 0
cmp -s "$work/a/results.jsonl" "$work/c/results.jsonl" || fail "resuming a complete file changes it"

# resume where there is nothing: as if it had not been said
run run "${plan[@]}" -o "$work/d" -q --resume
expect_code 0
same_rows "$work/a" "$work/d" "resuming from nothing gives other rows"

# resume with other arguments: refused, and the file stays
cp "$work/a/results.jsonl" "$work/kept"
refused 2 'resume with the same arguments' run --methods rk4 --problems pendulum -o "$work/a" --resume
cmp -s "$work/kept" "$work/a/results.jsonl" || fail "a refused resume changed the file"

# a run into the same folder keeps the earlier file beside the new one
run run --methods rk4 --problems oscillator --dt 0.5 --no-timing --no-stability -q -o "$work/a"
expect_code 0
cmp -s "$work/kept" "$work/a/results.jsonl.previous" || fail "the earlier results are lost"
run run --methods rk4 --problems oscillator --dt 0.5 --no-timing --no-stability -q -o "$work/a"
cmp -s "$work/kept" "$work/a/results.jsonl.previous2" || fail "the results before the earlier are lost"

# what is left empty is a slip, not "everything"; what can be no run is no success
for option in --methods --problems --dt --tol; do
  refused 2 "$option: nothing is given" run "$option" '' -o "$work/a"
done
refused 2 'give --dt instead of --tol' run --methods rk4 --tol 1e-3 -o "$work/a"
refused 2 'give --tol instead of --dt' run --methods radau --dt 0.01 -o "$work/a"

# stability limits: of the problem that was asked for; measured again where a cut lost them
spring=(--methods rk4,heun --problems damped_spring --set k=6e5,m=168,zeta=0.1 --dt 1/60 --no-timing --progress none)
limits() { grep -c '"record":"stability"' "$1/results.jsonl"; }
run run "${spring[@]}" -q -o "$work/f"
expect_code 0
[ "$(limits "$work/f")" = 2 ] || fail "$said: $(limits "$work/f") limits, not 2"
grep '"record":"stability"' "$work/f/results.jsonl" | grep -qv 'k=6e5' && fail "a limit of another spring"
cp "$work/f/results.jsonl" "$work/all_limits"
head -n -1 "$work/all_limits" >"$work/f/results.jsonl"
run run "${spring[@]}" -q -o "$work/f" --resume
cmp -s "$work/all_limits" "$work/f/results.jsonl" || fail "a lost limit is not measured again"
run run --methods rk4 --problems robertson --dt 1e-3 --no-timing -q -o "$work/g"
[ "$(limits "$work/g")" = 0 ] || fail "limits of what is not linear"

# Ctrl-C among the limits keeps those that are there
"$ODEMARK" run --methods '*' --problems oscillator --dt 0.5 --no-timing --progress none -o "$work/h" >/dev/null 2>"$work/err" &
process=$!
for _ in $(seq 2000); do
  grep -q '"record":"stability"' "$work/h/results.jsonl" 2>/dev/null && break
  sleep 0.01
done
kill -INT $process 2>/dev/null
wait $process
code=$? said="odemark run, interrupted among the limits"
expect_code 130
kept=$(limits "$work/h")
[ "$kept" -gt 0 ] || fail "$said: no limit was kept"
run run --methods '*' --problems oscillator --dt 0.5 --no-timing -q --resume -o "$work/h"
expect_code 0
[ "$(limits "$work/h")" -gt "$kept" ] || fail "$said: resuming measured nothing"

# Ctrl-C: exit code 130, whole lines only, and resuming completes them
long=(--methods 'taylor*,rk4' --problems oscillator,pendulum --no-timing --no-stability)
"$ODEMARK" run "${long[@]}" -o "$work/whole" -q >/dev/null 2>&1
"$ODEMARK" run "${long[@]}" --progress none -o "$work/e" >"$work/out" 2>"$work/err" &
process=$!
for _ in $(seq 200); do
  [ -e "$work/e/results.jsonl" ] && [ "$(wc -l <"$work/e/results.jsonl")" -gt 5 ] && break
  sleep 0.01
done
kill -INT $process 2>/dev/null
wait $process
code=$? said="odemark run, interrupted"
if [ "$code" = 130 ]; then
  expect_error 'interrupted: '
  expect_error '--resume'
  expect_quiet_stdout
  [ "$(tail -c 1 "$work/e/results.jsonl" | wc -l)" = 1 ] || fail "the last line is cut"
  [ "$(wc -l <"$work/e/results.jsonl")" -lt "$(wc -l <"$work/whole/results.jsonl")" ] || fail "nothing was left to do"
  run run "${long[@]}" -q -o "$work/e" --resume
  expect_code 0
else
  fail "interrupted, it ends with $code"
fi
same_rows "$work/whole" "$work/e" "interrupted and resumed gives other rows"
finish
