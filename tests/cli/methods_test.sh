#!/usr/bin/env bash
# `odemark methods`: facts as tables and as JSON that parses, with a reason for every null.
. "$(dirname "$0")/common.sh"

run methods --quiet
expect_code 0
expect_quiet_stderr
for name in rk4 tsitouras54 taylor20 sdirk2; do expect_output "$name"; done

run methods dormand_prince54 --quiet
expect_code 0
expect_output 'proved in integers'
expect_output '3.306567893'

run methods rk4 'adams_bashforth?' --measured --quiet
expect_code 0
expect_quiet_stderr
expect_output 'characteristic polynomial'
expect_output 'R(z)'

run methods --format json --quiet
expect_code 0
expect_quiet_stderr
if command -v python3 >/dev/null; then
  python3 - "$work/out" <<'PYTHON' || fail "the JSON is not what it should be"
import json, math, sys
methods = {m["id"]: m for m in json.load(open(sys.argv[1]))}
rk4 = methods["rk4"]
assert rk4["order"] == 4 and abs(rk4["real_interval"] - 2.785293563405282) < 1e-12
assert abs(rk4["imaginary_interval"] - math.sqrt(8)) < 1e-12
assert rk4["log_amplification"] == {"coefficient": -1 / 144, "power": 6}
assert methods["implicit_euler"]["real_interval"] == "infinity" and methods["implicit_euler"]["l_stable"]
for m in methods.values():
    for key, value in m.items():
        assert value is not None or m["reasons"][key], (m["id"], key)
PYTHON
fi

refused 2 'there is no method "rk5"' methods rk5
finish
