#!/usr/bin/env bash
# Builds the Debian packages twice, compares them to the bit, checks them with lintian, and tests them in a fresh root:
# tests/packages/run.sh [FOLDER] (default: a temporary one; 6 GB, about an hour on two cores)
# Run as root on Debian 12 with the packages' build dependencies (apt build-dep ./), debootstrap and lintian. The commit
# is built, not the working tree. FOLDER/first and FOLDER/second are not built again if they have packages.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(realpath -m "${1:-$(mktemp -d)}")

# Two clones, made at different times, at paths of different lengths.
build() {
  ls "$work/$1"/*.deb >/dev/null 2>&1 && return
  rm -rf "${work:?}/$1"
  mkdir -p "$work/$1"
  git clone -q "$root" "$work/$1/ixos"
  (cd "$work/$1/ixos" && dpkg-buildpackage -b -us -uc >"../build.log" 2>&1)
}
build first
build second
for deb in "$work"/first/*.deb; do cmp "$deb" "$work/second/$(basename "$deb")"; done
echo "Both builds made the same packages."
lintian --fail-on error "$work"/first/*.changes
"$root/tests/packages/install.sh" "$work/first" "$work"
