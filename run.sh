#!/usr/bin/env bash
# From a fresh Debian 12 to a report in a browser: installs what is missing, builds, runs a suite, writes the report.
# shellcheck source=tools/bootstrap.sh
source "$(dirname "${BASH_SOURCE[0]}")/tools/bootstrap.sh"

if [[ " $* " == *" -h "* || " $* " == *" --help "* ]]; then
  cat <<'HELP'
./run.sh [--no-install] [arguments of `odemark run`]

Installs the packages of apt-packages.txt that are missing, builds odemark, runs it and writes the report.
  --no-install    installs nothing: says what is missing and tries anyway
  --suite NAME    quick unless given
  -o DIRECTORY    where results and report go; out/ beside this script unless given
Everything else is for `odemark run`: see build/release/odemark run --help.
HELP
  exit 0
fi

read_arguments "$@"
[[ $sanitize == no ]] || fail 2 "--sanitize is an argument of ./test.sh"
out=
suite=(--suite quick)
for ((i = 0; i < ${#arguments[@]}; ++i)); do
  case ${arguments[i]} in
    -s* | --suite | --suite=*) suite=() ;;
    -o | --output) out=${arguments[i + 1]-} ;;
    -o?*) out=${arguments[i]#-o} ;;
    --output=*) out=${arguments[i]#--output=} ;;
  esac
done
if [[ -z $out ]]; then
  out=$root/out
  arguments+=(-o "$out")
fi

ensure_packages run "$install"
build_preset release --target odemark
odemark=$root/build/release/odemark

arguments=("${suite[@]}" "${arguments[@]}")
say "odemark run ${arguments[*]}"
"$odemark" run "${arguments[@]}" || fail $? "odemark run ended with exit code $?; no report was written"
say "odemark report -o $out"
"$odemark" report -o "$out" || fail $? "odemark report ended with exit code $?; the results are in $out"
say "the report: $out/report.html"
