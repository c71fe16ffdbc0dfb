#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests; arguments go to ctest: ./test.sh -R layers
# shellcheck source=tools/bootstrap.sh
source "$(dirname "${BASH_SOURCE[0]}")/tools/bootstrap.sh"

read_arguments "$@"
ensure_packages test "$install"
build_preset release
say "ctest ${arguments[*]}"
cd "$root"
exec ctest --preset release "${arguments[@]}"
