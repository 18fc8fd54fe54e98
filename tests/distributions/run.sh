#!/usr/bin/env bash
# Builds and tests Ixos in a clean root of another Debian release: tests/distributions/run.sh RELEASE [options]
#   --only build|tests|packages  one step; `tests` needs the root that `build` left
#   --part units|others          builds and runs the unit tests only, or all other quick tests
#   --packages                   after build and tests, builds the Debian packages there and tests them
#   --keep FOLDER                where the roots are (default: build/distributions/RELEASE; 5 GB)
# build     the packages that drivers/common.sh lists, and everything that it builds
# tests     the quick tests
# packages  debian/tests on the packages in a fresh root, see tests/packages/install.sh
# The commit is tested, not the working tree. Compiled objects stay in the host's ccache folder. Needs root, debootstrap
# and a mirror (IXOS_MIRROR); the exit status is 77 without root, or if root may not mount. IXOS_FASTER_ARCHS:
# instruction sets of the packages (docs/packages.md).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/tests/distributions

usage() {
  sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
release="" steps="build tests" packages="" work="" targets="" long=0 chosen=()
while [ $# -gt 0 ]; do
  case $1 in
    --only)
      case ${2:-} in build | tests | packages) steps=$2 ;; *) usage ;; esac
      shift
      ;;
    --part)
      case ${2:-} in
        units) targets=unit_tests chosen=(-L unit) ;;
        others) targets=other_tests long=1 chosen=(-LE 'long|unit') ;; # ctest takes one -LE
        *) usage ;;
      esac
      shift
      ;;
    --packages) packages=packages ;;
    --keep)
      [ $# -gt 1 ] || usage
      work=$(realpath -m "$2")
      shift
      ;;
    -*) usage ;;
    *)
      [ -z "$release" ] || usage
      release=$1
      ;;
  esac
  shift
done
[ -n "$release" ] || usage
if [ "$(id -u)" -ne 0 ] || ! unshare --mount true 2>/dev/null; then
  echo "Left out: a root of $release needs root that may mount."
  exit 77
fi
if ! command -v debootstrap apt-get >/dev/null; then
  echo "Left out: a root of $release needs debootstrap or apt."
  exit 77
fi
work=${work:-$root/build/distributions/$release}
export IXOS_BIND="${CCACHE_DIR:-$HOME/.cache/ccache}/distributions/$release /ccache"

inside() { "$here/root.sh" inside "$work/build" "$@"; }
# logged NAME COMMAND...: into NAME.log; shows its end if the command fails.
logged() {
  local log=$work/$1.log
  "${@:2}" >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    echo "$release: $1 failed: $log" >&2
    return 1
  }
}
need_build() { [ -d "$work/build/ixos" ] || { echo "$work has no build: run $0 $release --only build" >&2; exit 1; }; }

make_root() {
  mkdir -p "$work"
  "$here/root.sh" make "$release" "$work/bare"
  rm -rf "$work/build"
  cp -a "$work/bare" "$work/build"
  git clone -q "$root" "$work/build/ixos"
}

build() {
  make_root
  # -N: tests/run.sh installs and builds, and ctest names the tests.
  logged build inside env CCACHE_DIR=/ccache targets="$targets" /ixos/tests/run.sh -N
  inside sh -c 'dpkg-query -W trilinos-dev openmpi-bin libhdf5-openmpi-dev libfmt-dev g++ cmake'
  echo "$release: built, with $(grep -E ': warning: ' "$work/build.log" | sort -u | wc -l) warnings"
}

tests() {
  need_build
  logged tests inside env CCACHE_DIR=/ccache targets="$targets" IXOS_LONG=$long /ixos/tests/run.sh -j 2 "${chosen[@]}"
  sed -n '/tests passed/,$p' "$work/tests.log"
}

packages() {
  [ -d "$work/build/ixos" ] || make_root
  rm -rf "$work/build/packages"
  git clone -q "$root" "$work/build/packages/ixos"
  logged dependencies inside sh -c \
    'apt-get update -qq && cd /packages/ixos && apt-get build-dep -y -qq ./ && apt-get install -y -qq ccache'
  logged packages inside env IXOS_CCACHE=ccache CCACHE_DIR=/ccache "IXOS_FASTER_ARCHS=${IXOS_FASTER_ARCHS-all}" \
    sh -c 'cd /packages/ixos && dpkg-buildpackage -b -us -uc'
  IXOS_BIND="" "$root/tests/packages/install.sh" "$work/build/packages" "$work" "$release"
}

[ "$steps" != packages ] || packages=""
for step in $steps $packages; do
  echo "== minute $((SECONDS / 60)): $release: $step"
  "$step"
done
echo "== minute $((SECONDS / 60)): $release: done"
