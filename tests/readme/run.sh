#!/usr/bin/env bash
# Runs the commands of README.md in order, in a clean root of Debian 12: tests/readme/run.sh [FOLDER]
# blocks.py finds the commands, and says which are shortened or left out. FOLDER (default: a temporary one; 5 GB) keeps the
# bare root for the next time. The commit is used, not the working tree. It takes 40 minutes on two cores, half of that if
# the host's ccache has the objects. Needs root that may mount; without, the exit status is 77.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ "$(id -u)" -ne 0 ] || ! unshare --mount true 2>/dev/null; then
  echo "tests/readme/run.sh: left out: a clean root needs root that may mount"
  exit 77
fi
work=$(realpath -m "${1:-$(mktemp -d)}")
mkdir -p "$work"
"$root/tests/distributions/root.sh" make bookworm "$work/bare"
rm -rf "$work/system"
cp -a "$work/bare" "$work/system"
git clone -q "$root" "$work/system/ixos"
export IXOS_BIND="${CCACHE_DIR:-$HOME/.cache/ccache} /ccache"
# As the README says for root.
inside=("$root/tests/distributions/root.sh" inside "$work/system" env CCACHE_DIR=/ccache OMPI_ALLOW_RUN_AS_ROOT=1
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OPENBLAS_NUM_THREADS=1)
# shellcheck disable=SC2016 # the shell of the root expands it
"$root/tests/readme/blocks.py" --run "${inside[@]}" sh -c 'cd /ixos && exec "$@"' sh
