# The scripts *_pictures.sh source this file: their arguments, FOLDER [IMAGES [IXOS [ARGUMENTS]]], and run().
# Results go to FOLDER, pictures to IMAGES (default: docs/images). ARGUMENTS are further ones of ixos, as of --set.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
runs=$(realpath -m "${1:?"usage: $(basename "$0") FOLDER [IMAGES [IXOS [ARGUMENTS]]]"}")
images=$(realpath -m "${2:-$root/docs/images}")
ixos=${3:-$root/build/release/drivers/ixos}
arguments=("${@:4}")
plot=$root/drivers/plot
step="Time Integrator/Time Step Control"
export OPENBLAS_NUM_THREADS=1
mkdir -p "$runs" "$images"

# run NAME SCENE [SETTING...]: runs a scene of xml/ with settings LIST/NAME=VALUE into FOLDER/NAME. Does not repeat a run
# that is finished. Returns the exit status of ixos.
run() {
  local name=$1 scene=$2 settings=() setting
  shift 2
  ! grep -Eqs '"status": "(completed|stopped|diverged)"' "$runs/$name/summary.json" || return 0
  for setting; do settings+=(--set "$setting"); done
  echo "$name"
  "$ixos" "$root/xml/$scene.xml" --quiet --overwrite --output "$runs/$name" "${settings[@]}" "${arguments[@]}" \
    >"$runs/$name.log" 2>&1 || { local status=$?; cat "$runs/$name.log" >&2; return $status; }
}
