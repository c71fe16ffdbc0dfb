#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests; arguments go to ctest: ./test.sh -R layers
# shellcheck source=tools/bootstrap.sh
source "$(dirname "${BASH_SOURCE[0]}")/tools/bootstrap.sh"

if [[ " $* " == *" -h "* || " $* " == *" --help "* ]]; then
  cat <<'HELP'
./test.sh [--no-install] [--sanitize] [arguments of ctest]

Installs the packages of apt-packages.txt that are missing, builds everything and runs the tests.
  --no-install    installs nothing: says what is missing and tries anyway
  --sanitize      the tests that take seconds, under AddressSanitizer and UndefinedBehaviorSanitizer, in a build of their own
Everything else is for ctest: ./test.sh -R layers
HELP
  exit 0
fi

read_arguments "$@"
preset=release
packages=test
if [[ $sanitize == yes ]]; then
  preset=sanitize
  packages=sanitize
fi
ensure_packages "$packages" "$install"
build_preset "$preset"
say "ctest ${arguments[*]}"
cd "$root"
exec ctest --preset "$preset" "${arguments[@]}"
