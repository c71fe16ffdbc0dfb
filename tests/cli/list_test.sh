#!/usr/bin/env bash
# `odemark list` in its formats: JSON that parses, names that can be typed back, tables on stdout only.
. "$(dirname "$0")/common.sh"

run list --format names
expect_code 0
expect_quiet_stderr
for name in rk4 tsitouras54 taylor20 oscillator kepler_e06 quick gate; do expect_output "$name"; done
[ "$(sort "$work/out" | uniq -d | wc -l)" = 0 ] || fail "a name is listed twice"

run list --methods --format names
grep -q oscillator "$work/out" && fail "problems among the methods"
run list --problems --format names
grep -q '^rk4$' "$work/out" && fail "methods among the problems"
cp "$work/out" "$work/problems"

run list --format json
expect_code 0
expect_quiet_stderr
if command -v python3 >/dev/null; then
  python3 - "$work/out" "$work/problems" <<'PYTHON' || fail "the JSON is not what it should be"
import json, sys
everything = json.load(open(sys.argv[1]))
names = open(sys.argv[2]).read().split()
assert [p["id"] for p in everything["problems"]] == names
rk4 = next(m for m in everything["methods"] if m["id"] == "rk4")
assert rk4["order"] == 4 and rk4["fixed_steps"] and not rk4["error_control"] and rk4["source"]
spring = next(p for p in everything["problems"] if p["id"] == "damped_spring")
assert any(p["name"] == "zeta" and p.get("shorthand") for p in spring["parameters"])
assert any(p["name"] == "k" and p["value"] == 1 for p in spring["parameters"]), spring["parameters"]
assert "quick" in everything["suites"]
PYTHON
fi

run list
expect_code 0
expect_quiet_stderr
expect_output 'rk4'
expect_output 'Suites: quick'
finish
