#!/usr/bin/env bash
# A clean root of a Debian release, to build and to test in. Needs to be root.
#   root.sh make RELEASE FOLDER           makes it with debootstrap, unless FOLDER exists
#   root.sh inside FOLDER COMMAND...      runs a command in it
# IXOS_MIRROR: where packages come from. IXOS_BIND="HOST INSIDE": a folder of the host that the command sees, too. The
# mounts of a command are its own: they end with it, however it ends.
set -euo pipefail

make_root() { # RELEASE FOLDER
  [ ! -d "$2" ] || return 0
  command -v debootstrap >/dev/null || {
    apt-get update -qq
    apt-get install -y -qq --no-install-recommends debootstrap >/dev/null
  }
  rm -rf "$2.unfinished"
  mkdir -p "$2.unfinished"
  # Its mounts of /proc and /sys are its own, too.
  unshare --mount --propagation private debootstrap --variant=minbase "$1" "$2.unfinished" \
    "${IXOS_MIRROR:-http://deb.debian.org/debian}" >"$2.log" 2>&1 ||
    { tail -n 3 "$2.log" >&2; return 1; }
  # A mirror may be a picture of an earlier day, whose lists of unstable count as expired.
  echo 'Acquire::Check-Valid-Until "false";' >"$2.unfinished/etc/apt/apt.conf.d/90snapshot"
  mv "$2.unfinished" "$2"
}

enter() { # FOLDER COMMAND..., in a namespace of mounts
  local folder=$1
  shift
  mount -t proc proc "$folder/proc"
  mount -t sysfs -o ro sysfs "$folder/sys"
  mkdir -p "$folder/dev/shm" "$folder/dev/pts"
  mount -t tmpfs -o mode=1777 tmpfs "$folder/dev/shm"
  mount -t devpts -o gid=5,mode=620,ptmxmode=666 devpts "$folder/dev/pts"
  cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
  if [ -n "${IXOS_BIND:-}" ]; then
    mkdir -p "${IXOS_BIND% *}" "$folder${IXOS_BIND##* }"
    mount --bind "${IXOS_BIND% *}" "$folder${IXOS_BIND##* }"
  fi
  exec chroot "$folder" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive ${http_proxy:+"http_proxy=$http_proxy"} "$@"
}

case ${1:-} in
  make) make_root "$2" "$3" ;;
  inside) exec unshare --mount --propagation private "$0" enter "${@:2}" ;;
  enter) enter "${@:2}" ;;
  *)
    echo "usage: root.sh make RELEASE FOLDER | inside FOLDER COMMAND..." >&2
    exit 2
    ;;
esac
