# shellcheck shell=bash disable=SC2034  # `install`, `sanitize` and `arguments` are for who sources this
# Sourced by run.sh, test.sh and .ci/run: finds the tree, installs what apt-packages.txt asks for, configures, builds.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\n== %s\n' "$*" >&2; }
note() { printf '   %s\n' "$*" >&2; }
fail() { # exit code, sentence
  printf '\n%s: %s\n' "$(basename "$0")" "$2" >&2
  exit "$1"
}

# Prints the packages of the list that this machine lacks. $1: `run`, `test` or `sanitize`; $2: `required` or `optional`.
lacking() {
  local names words alternative
  while read -r names words; do
    [[ $1 == run && " $words " == *" test "* ]] && continue
    [[ $1 != sanitize && " $words " == *" sanitize "* ]] && continue
    [[ $2 == optional && " $words " != *" optional "* ]] && continue
    [[ $2 == required && " $words " == *" optional "* ]] && continue
    for alternative in ${names//|/ }; do
      [[ $(dpkg-query -W -f '${db:Status-Status}' "$alternative" 2>/dev/null) == installed ]] && continue 2
    done
    echo "${names%%|*}"
  done < <(sed 's/#.*//; /^[[:space:]]*$/d' "$root/apt-packages.txt")
}

apt() {
  local as_root=()
  [[ $(id -u) == 0 ]] || as_root=(sudo)
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@" >&2
}

# Brings the machine to the list. $1: `run`, `test` or `sanitize`; $2: `yes` or `no`, whether installing is allowed.
ensure_packages() {
  local required optional
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "no apt here; odemark needs these packages, or what your system calls them:"
    sed 's/#.*//; /^[[:space:]]*$/d; s/^/   /' "$root/apt-packages.txt" >&2
    return
  fi
  mapfile -t required < <(lacking "$1" required)
  mapfile -t optional < <(lacking "$1" optional)
  ((${#required[@]} + ${#optional[@]})) || return 0
  if [[ $2 == no ]]; then
    ((${#required[@]} == 0)) || say "missing, and not installed because of --no-install: ${required[*]}"
    ((${#optional[@]} == 0)) || say "missing, but optional: ${optional[*]}"
    return
  fi
  if [[ $(id -u) != 0 ]] && ! command -v sudo >/dev/null; then
    fail 2 "installing needs root or sudo. As root: apt-get install ${required[*]} ${optional[*]}. Or: --no-install"
  fi
  say "installing ${required[*]} ${optional[*]}"
  apt update || note "apt-get update failed; trying with the package lists at hand"
  if ((${#required[@]})); then
    apt install -y --no-install-recommends "${required[@]}" ||
      fail $? "apt-get could not install ${required[*]}. Install them by hand, then run again with --no-install."
  fi
  local package
  for package in "${optional[@]}"; do
    apt install -y --no-install-recommends "$package" || note "no $package: odemark goes on without it"
  done
}

# Configures and builds. $1: preset; further arguments go to the build (--target ...). One compiler for each processor: ninja's
# one or two more only push each other out of the caches.
build_preset() {
  local preset=$1
  shift
  command -v cmake >/dev/null || fail 2 "cmake is missing: install the packages of apt-packages.txt"
  say "configuring build/$preset"
  (cd "$root" && cmake --preset "$preset") >&2 || fail $? "the configuration of build/$preset failed; the reason is above"
  say "building build/$preset (the first time takes some minutes)"
  (cd "$root" && cmake --build --preset "$preset" -j "$(nproc)" "$@") >&2 || fail $? "the build of build/$preset failed; the first error is above"
}

# Takes --no-install and --sanitize out of the arguments: sets `install`, `sanitize` and the array `arguments`.
read_arguments() {
  install=yes
  sanitize=no
  arguments=()
  local argument
  for argument in "$@"; do
    case $argument in
      --no-install) install=no ;;
      --sanitize) sanitize=yes ;;
      *) arguments+=("$argument") ;;
    esac
  done
}
