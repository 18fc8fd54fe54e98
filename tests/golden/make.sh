#!/usr/bin/env bash
# Writes what a release keeps beside its scenes: tests/golden/make.sh BUILD FOLDER
# BUILD is a build folder of the release, FOLDER is tests/golden/VERSION with its scenes. The script runs each scene. If
# the scene has an Output/Checkpoint/Interval, SCENE.h5 becomes its checkpoint half-way, of at most 60 KB. columns.txt
# becomes the list of columns and keys of all results.
set -euo pipefail
if [ $# -ne 2 ]; then
  echo "usage: tests/golden/make.sh BUILD FOLDER" >&2
  exit 2
fi
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
ixos=$(realpath "$1")/drivers/ixos
cd "$2"
version=$(basename "$PWD")
if [ "$("$ixos" --version | head -n 1)" != "ixos $version" ]; then
  echo "make.sh: $ixos is no build of the version $version, after which the folder is named" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
echo "# Names that later versions keep: columns of history.csv, keys of summary.json. make.sh writes them." \
  >"$work/columns.txt"
for scene in *.xml; do
  name=${scene%.xml}
  "$ixos" "$scene" --quiet --output "$work/$name"
  /usr/bin/python3 "$tests/result_names.py" "$work/$name" >>"$work/columns.txt"
  mapfile -t checkpoints < <(find "$work/$name" -name 'checkpoint-*.h5' | sort -V)
  grep -q '"Checkpoint"' "$scene" || continue
  if [ ${#checkpoints[@]} -ne 2 ]; then  # one is that of the end
    echo "make.sh: $scene leaves ${#checkpoints[@]} checkpoints, not 2" >&2
    exit 1
  fi
  cp "${checkpoints[0]}" "$work/$name.h5"
  bytes=$(stat -c %s "$work/$name.h5")
  echo "$name.h5: $(basename "${checkpoints[0]}" .h5) of a run to $(basename "${checkpoints[1]}" .h5), $bytes bytes"
  if ((bytes > 61440)); then
    echo "make.sh: $name.h5 is larger than 60 KB; give the scene a smaller mesh" >&2
    exit 1
  fi
done
rm -f -- *.h5
mv "$work"/*.h5 "$work/columns.txt" .
