# What every script here needs: a folder of its own, and words for what is expected.
# shellcheck shell=bash
set -u
ODEMARK=${ODEMARK:?path of the program}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }

# run ARGS...: stdout to $work/out, stderr to $work/err, exit code in $code
run() {
  said="odemark $*"
  "$ODEMARK" "$@" >"$work/out" 2>"$work/err"
  code=$?
}
expect_code() { [ "$code" = "$1" ] || fail "$said: exit code $code, not $1: $(cat "$work/err")"; }
expect_error() { grep -qF -- "$1" "$work/err" || fail "$said: stderr lacks \"$1\": $(cat "$work/err")"; }
expect_output() { grep -qF -- "$1" "$work/out" || fail "$said: stdout lacks \"$1\": $(head -5 "$work/out")"; }
expect_quiet_stdout() { [ ! -s "$work/out" ] || fail "$said: stdout is not empty: $(head -3 "$work/out")"; }
expect_quiet_stderr() { [ ! -s "$work/err" ] || fail "$said: stderr is not empty: $(head -3 "$work/err")"; }
expect_one_sentence() {
  [ "$(wc -l <"$work/err")" = 1 ] || fail "$said: not one sentence: $(cat "$work/err")"
  grep -q '^odemark: ' "$work/err" || fail "$said: does not say who speaks: $(cat "$work/err")"
}
# refused CODE TEXT ARGS...: that exit code, one sentence on stderr with TEXT, nothing on stdout
refused() {
  wanted=$1 text=$2
  shift 2
  run "$@"
  expect_code "$wanted"
  expect_error "$text"
  expect_one_sentence
  expect_quiet_stdout
}
finish() {
  [ "$failures" = 0 ] || { printf '%d failed\n' "$failures"; exit 1; }
  printf 'all as expected\n'
}
