#!/usr/bin/env bash
# Builds the Debian packages of the commit, checks them with lintian, and tests them in a clean root:
#   tests/packages/run.sh [FOLDER]            (default: a temporary one; 6 GB)
#   tests/packages/run.sh --twice [FOLDER]    builds them twice, and compares them to the bit
# A build for one instruction set takes half an hour on two cores, each further one 20 minutes: IXOS_FASTER_ARCHS, see
# docs/packages.md. Compiled objects are kept in ccache's folder; the second build of --twice is made without them, in
# another folder. --twice builds for one instruction set, which is enough to see what differs. Needs root on Debian 12,
# and mounts unless --twice; elsewhere the exit status is 77. FOLDER/packages is built anew if it has other packages.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
twice=false
if [ "${1:-}" = --twice ]; then
  twice=true
  shift
fi
if [ "$(id -u)" -ne 0 ] || ! grep -q bookworm /etc/os-release ||
  { ! $twice && ! unshare --mount true 2>/dev/null; }; then
  echo "tests/packages/run.sh: left out: needs root on Debian 12, which may mount"
  exit 77
fi
work=$(realpath -m "${1:-$(mktemp -d)}")
commit=$(git -C "$root" rev-parse HEAD)
. "$root/drivers/install.sh"
install_missing ccache debootstrap dpkg-dev git lintian
apt-get update -qq
DEBIAN_FRONTEND=noninteractive apt-get build-dep -y -qq "$root" >/dev/null

# build NAME CCACHE: makes the packages in a new clone. Two names give two paths and two times. A name has the same path
# each time, so ccache need not rewrite paths, which would show in the objects.
build() {
  local made="$commit for ${IXOS_FASTER_ARCHS-all}"
  [ "$(cat "$work/$1/made" 2>/dev/null)" != "$made" ] || return 0
  rm -rf "${work:?}/$1"
  mkdir -p "$work/$1"
  git clone -q "$root" "$work/$1/ixos"
  if ! (cd "$work/$1/ixos" &&
    env -u CCACHE_BASEDIR -u CCACHE_NOHASHDIR IXOS_CCACHE="$2" CCACHE_DIR="${CCACHE_DIR:-$HOME/.cache/ccache}" \
      dpkg-buildpackage -b -us -uc >"../build.log" 2>&1); then
    tail -50 "$work/$1/build.log"
    exit 1
  fi
  echo "$made" >"$work/$1/made"
}

if $twice; then
  export IXOS_FASTER_ARCHS=""
  build packages ccache
  build second OFF
  for deb in "$work"/packages/*.deb; do cmp "$deb" "$work/second/$(basename "$deb")"; done
  echo "Both builds made the same packages."
else
  build packages ccache
  lintian --fail-on error "$work"/packages/*.changes
  "$root/tests/packages/install.sh" "$work/packages" "$work"
fi
