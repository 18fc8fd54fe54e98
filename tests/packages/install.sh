#!/usr/bin/env bash
# Tests Debian packages in a fresh root: tests/packages/install.sh PACKAGES FOLDER [RELEASE]
# Installs the packages of the folder PACKAGES in FOLDER/system, a copy of FOLDER/bare (made if it does not exist, of the
# release bookworm or RELEASE), runs debian/tests there, removes the packages, and looks for files that stayed. Run as
# root.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
packages=$(realpath "$1")
work=$(realpath -m "$2")
"$root/tests/distributions/root.sh" make "${3:-bookworm}" "$work/bare"
rm -rf "$work/system"
cp -a "$work/bare" "$work/system"
mkdir -p "$work/system/packages/debian" "$work/system/packages/tests/support"
cp "$packages"/*.deb "$work/system/packages"
cp -r "$root/debian/tests" "$work/system/packages/debian"
cp "$root/tests/support/openmpi.env" "$work/system/packages/tests/support"

inside() { "$root/tests/distributions/root.sh" inside "$work/system" "$@"; }
install_packages() { # names of packages
  local files
  files=$(printf ' /packages/%s_*.deb' "$@")
  inside sh -c "apt-get install -y -qq --no-install-recommends $files" >>"$work/apt.log" 2>&1 || { tail -n 20 "$work/apt.log" >&2; return 1; }
}
test_installed() {
  echo "== $1"
  inside sh -c "mkdir /tmp/$1 && AUTOPKGTEST_TMP=/tmp/$1 IXOS_FASTER_ARCHS='${IXOS_FASTER_ARCHS-all}' /packages/debian/tests/$1"
}

inside apt-get update -qq
install_packages ixos python3-ixos
inside sh -c 'command -v ixos ixos-study ixos-plot && ls /usr/include/ixos/model.hpp'
test_installed ball
test_installed python
install_packages libixos-dev ixos-doc
test_installed programs
inside apt-get purge -y -qq ixos python3-ixos libixos-dev ixos-doc >>"$work/apt.log" 2>&1
left=$(inside find / -xdev \( -path /packages -o -path /tmp -o -path /proc -o -path /sys \) -prune -o -iname '*ixos*' -print)
[ -z "$left" ] || { echo "Left after removal: $left" >&2; exit 1; }
echo "Installed, tested, removed; nothing stayed."
