#!/usr/bin/env bash
# Builds the Debian packages of the commit, checks them with lintian, and tests them in a clean root:
#   tests/packages/run.sh [FOLDER]            (default: a temporary one; 6 GB)
#   tests/packages/run.sh --twice [FOLDER]    builds them twice, and compares them to the bit: half an hour
# It takes 40 minutes on two cores, less with fewer instruction sets: IXOS_FASTER_ARCHS, see docs/packages.md. --twice
# builds for one, which is enough to see what differs. Needs root on Debian 12, and mounts unless --twice; elsewhere the
# exit status is 77. FOLDER/packages and its like are built anew if they have packages of another commit.
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
install_missing debootstrap dpkg-dev git lintian
apt-get update -qq
DEBIAN_FRONTEND=noninteractive apt-get build-dep -y -qq "$root" >/dev/null

# build NAME: makes the packages in a new clone. Two names give two paths and two times.
build() {
  [ "$(cat "$work/$1/commit" 2>/dev/null)" != "$commit" ] || return 0
  rm -rf "${work:?}/$1"
  mkdir -p "$work/$1"
  git clone -q "$root" "$work/$1/ixos"
  if ! (cd "$work/$1/ixos" && dpkg-buildpackage -b -us -uc >"../build.log" 2>&1); then
    tail -50 "$work/$1/build.log"
    exit 1
  fi
  echo "$commit" >"$work/$1/commit"
}

if $twice; then
  export IXOS_FASTER_ARCHS=""
  build first
  build second
  for deb in "$work"/first/*.deb; do cmp "$deb" "$work/second/$(basename "$deb")"; done
  echo "Both builds made the same packages."
else
  build packages
  lintian --fail-on error "$work"/packages/*.changes
  "$root/tests/packages/install.sh" "$work/packages" "$work"
fi
