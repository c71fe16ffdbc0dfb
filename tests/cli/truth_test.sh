#!/usr/bin/env bash
# odemark truth: one solution, and the stored ones computed again.
. "$(dirname "$0")/common.sh"

run truth kepler_e06 --digits 20
expect_code 0
expect_quiet_stderr
expect_output 'certified in units of the problem'

run truth --verify kepler_e06 dahlquist --quiet
expect_code 0
expect_quiet_stderr
expect_output '2 stored solutions computed again: 2 hold, 0 do not'

# a sample is chosen by its seed alone
run truth --verify --sample 3 --within 1 --seed one --format json --quiet
expect_code 0
grep '"preset"' "$work/out" >"$work/first"
run truth --verify --sample 3 --within 1 --seed one --format json -j 2 --quiet
grep '"preset"' "$work/out" | cmp -s - "$work/first" || fail "the same seed chose another sample"
run truth --verify --sample 3 --within 1 --seed two --format json --quiet
grep '"preset"' "$work/out" | cmp -s - "$work/first" && fail "another seed chose the same sample"
[ "$(wc -l <"$work/first")" = 3 ] || fail "a sample of 3 has $(wc -l <"$work/first") presets"

refused 2 'truth needs a PROBLEM' truth
refused 2 'one problem at a time' truth kepler_e06 robertson
refused 2 '--sample requires --verify' truth kepler_e06 --sample 3
refused 2 'there is no problem "kepler_e0x"' truth --verify kepler_e0x
refused 2 'too large to be stored' truth --verify heat_rod_100000
refused 2 'no stored solution was computed that fast' truth --verify --within 1e-9
finish
