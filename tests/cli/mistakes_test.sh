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
refused 2 '--nonsense' run "${plan[@]}" --nonsense
refused 2 'nonsense' nonsense
refused 2 'subcommand'
refused 2 'yaml' list --format yaml
refused 2 'did you mean' stability --methods rk5
refused 2 'is no step: it must be above 0' stability --dt 0
refused 2 'did you mean "kepler"?' truth keplr
[ ! -e "$out" ] || fail "something was written into $out: $(ls "$out")"

run --version
expect_code 0
expect_output odemark
expect_quiet_stderr
run --help
expect_code 0
expect_output 'Exit codes'
expect_quiet_stderr
finish
