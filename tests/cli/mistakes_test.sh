#!/usr/bin/env bash
# What is typed wrong is answered in one sentence with the nearest right thing, exit code 2, and nothing is written.
. "$(dirname "$0")/common.sh"
out="$work/results"
plan=(--methods rk4 --problems oscillator -o "$out")

refused 2 'did you mean "rk4"?' run --methods rk5 --problems oscillator -o "$out"
refused 2 'did you mean "oscillator"?' run --methods rk4 --problems oscilator -o "$out"
refused 2 'did you mean "quick"?' run --suite quik -o "$out"
refused 2 'did you mean "zeta"?' run --methods rk4 --problems damped_spring --set zetta=1 -o "$out"
refused 2 'is no step: it must be a finite number above 0' run "${plan[@]}" --dt 0
refused 2 'is no step: it must be a finite number above 0' run "${plan[@]}" --dt -0.1
refused 2 '"nan" is no value for --dt' run "${plan[@]}" --dt nan
refused 2 '"inf" is no value for --dt' run "${plan[@]}" --dt inf
refused 2 '"abc" is no value for --dt' run "${plan[@]}" --dt abc
refused 2 '"" is no value for --dt' run "${plan[@]}" --dt 0.1,
refused 2 '"1/0" is no value for --dt' run "${plan[@]}" --dt 1/0
refused 2 'is longer than the 10 s of oscillator' run "${plan[@]}" --dt 11
refused 2 'at most 1e9 are run' run "${plan[@]}" --dt 1e-12
refused 2 'write start:ratio:count' run "${plan[@]}" --dt 0.1:0.5
refused 2 'the ratio must be above 0 and not 1' run "${plan[@]}" --dt 0.1:1:10
refused 2 'the ratio must be above 0 and not 1' run "${plan[@]}" --dt 0.1:0.5:1.5
refused 2 'is no tolerance: it must lie between 0 and 1' run --methods tsitouras54 --problems oscillator --tol 0 -o "$out"
refused 2 'is no tolerance: it must lie between 0 and 1' run --methods tsitouras54 --problems oscillator --tol 2 -o "$out"
refused 2 '"quad" is no number type' run "${plan[@]}" --scalar quad
refused 2 '"pid" is no step-size filter' run "${plan[@]}" --filter pid
refused 2 'is out of range for oscillator' run "${plan[@]}" --set k=-1
refused 2 'contradicts another setting' run --methods rk4 --problems damped_spring --set zeta=0.1,c=7 -o "$out"
refused 2 'is set twice' run "${plan[@]}" --set k=1,k=2
refused 2 'is not a setting' run "${plan[@]}" --set k
refused 2 'is no number of jobs: 1 to 256' run "${plan[@]}" -j 0
refused 2 '--time-limit' run "${plan[@]}" --time-limit 0
refused 2 '--time-limit' run "${plan[@]}" --time-limit -1
refused 2 '"-1" is no number of seconds: it must be above 0' run "${plan[@]}" --time-limit -1
refused 2 '"many" is no number of jobs: 1 to 256' run "${plan[@]}" -j many
refused 2 '"0" is no number of jobs: 1 to 256' stability -j 0
refused 2 '"x" is no number of seconds: it must be above 0' truth --verify --within x
refused 2 '"many" is no number of solutions' truth --verify --sample many
refused 2 '"60" is no number of digits that can be asked for: 1 to 38' truth oscillator --digits 60
refused 2 'there is no style of progress "fancy": auto, bar, lines, none' run "${plan[@]}" --progress fancy
refused 2 'did you mean "json"?' list --format jsno
refused 2 'run has no option --suit (did you mean "--suite"?)' run --suit quick
refused 2 'run has no option --suit (did you mean "--suite"?)' run --suit=quick
refused 2 'there is no option --verson (did you mean "--version"?)' --verson
refused 2 'run does not take "quick"' run quick
refused 2 'did you mean "dormand_prince54"?' run --methods dopri5 --problems oscillator -o "$out"
refused 2 'did you mean "dop853"?' methods DOP853
refused 2 '--nonsense' run "${plan[@]}" --nonsense
refused 2 'nonsense' nonsense
refused 2 'subcommand'
refused 2 'yaml' list --format yaml
refused 2 'did you mean' stability --methods rk5
refused 2 'is no step: it must be above 0' stability --dt 0
refused 2 'did you mean "kepler"?' truth keplr
[ ! -e "$out" ] || fail "something was written into $out: $(ls "$out")"

if "$ODEMARK" bench --help 2>/dev/null | grep -q benchmark_filter; then  # built with Google Benchmark
  refused 2 'is no regular expression' bench '--benchmark_filter=('
  refused 2 'matches none of the ' bench --benchmark_filter=nosuch
  refused 2 'matches none of the ' bench --benchmark_filter=-.
  run bench --benchmark_filter=rk4/steps --benchmark_list_tests
  expect_code 0
  expect_output 'oscillator/rk4/steps'
  run bench --help
  expect_output '--tax'
fi

run run --help
expect_code 0
grep -q '{false}' "$work/out" && fail "the help shows what flags are inside"
expect_output 'each half the one before'
expect_output 'default: out'
run check --help
expect_output 'default: thresholds.toml'
expect_output 'optional = true'

# a step that decays says what is left of the motion, one that grows what becomes of it
run stability --problem damped_spring --set k=6e5,m=168,zeta=0.1 --dt 1/60 --methods heun,explicit_euler
expect_code 0
expect_output 'amplitude, per second'
grep -Eq '^heun +stable .* x 0\.[0-9]+ ' "$work/out" || fail "no word on the decay: $(cat "$work/out")"
grep -Eq '^explicit_euler +unstable .* x 4\.[0-9]+e\+07 ' "$work/out" || fail "exp(17.51) is not said: $(cat "$work/out")"

run --version
expect_code 0
expect_output odemark
expect_quiet_stderr
run --help
expect_code 0
expect_output 'Exit codes'
expect_quiet_stderr
finish
