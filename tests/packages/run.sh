#!/usr/bin/env bash
# Builds the Debian packages twice, compares them to the bit, checks them with lintian, and tests them in a fresh root:
# tests/packages/run.sh [FOLDER] (default: a temporary one, about 6 GB)
# Run as root on Debian 12 with the packages' build dependencies (apt build-dep ./), debootstrap and lintian. FOLDER/first
# and FOLDER/second are not built again if they have packages. The commit is tested, not the working tree.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(realpath -m "${1:-$(mktemp -d)}")
mirror=${IXOS_MIRROR:-http://deb.debian.org/debian}

# Two clones, at paths of different lengths and at different times.
build() {
  ls "$work/$1"/*.deb >/dev/null 2>&1 && return
  mkdir -p "$work/$1"
  git clone -q "$root" "$work/$1/ixos"
  (cd "$work/$1/ixos" && dpkg-buildpackage -b -us -uc >"../build.log" 2>&1)
}
build first
build second
for deb in "$work"/first/*.deb; do cmp "$deb" "$work/second/$(basename "$deb")"; done
echo "Both builds made the same packages."

lintian --fail-on error "$work"/first/*.changes

[ -d "$work/bare" ] || debootstrap --variant=minbase bookworm "$work/bare" "$mirror"
rm -rf "$work/system"
cp -a "$work/bare" "$work/system"
mkdir "$work/system/packages"
cp -r "$work"/first/*.deb "$root/debian/tests" "$work/system/packages"
mount -t proc proc "$work/system/proc"
trap 'umount "$work/system/proc"' EXIT
inside() {
  chroot "$work/system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}
test_installed() {
  echo "== $1"
  inside sh -c "mkdir /tmp/$1 && AUTOPKGTEST_TMP=/tmp/$1 /packages/tests/$1"
}
inside apt-get update -qq
inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/ixos_*.deb /packages/python3-ixos_*.deb >/tmp/apt.log'
inside sh -c 'command -v ixos ixos-study ixos-plot && ls /usr/include/ixos/model.hpp'
test_installed ball
test_installed python
inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/libixos-dev_*.deb /packages/ixos-doc_*.deb >/tmp/apt.log'
test_installed programs
inside apt-get purge -y -qq ixos python3-ixos libixos-dev ixos-doc >/dev/null
left=$(inside find / -xdev \( -path /packages -o -path /tmp -o -path /proc \) -prune -o -iname '*ixos*' -print)
[ -z "$left" ] || { echo "Left after removal: $left" >&2; exit 1; }
echo "Installed, tested, removed; nothing stayed."
