#!/bin/bash
# The runs behind docs/results.md's strip: every scheme, contact element and time step; the reference; the mesh study.
# Finished runs are not repeated. About an hour on one core.
#   tests/bench/strip_runs.sh FOLDER [IXOS [ARGUMENTS]]      ARGUMENTS: further ones of ixos, as of --set
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:?"usage: strip_runs.sh FOLDER [IXOS [ARGUMENTS]]"}
ixos=${2:-$root/build/release/drivers/ixos}
arguments=("${@:3}")
export OPENBLAS_NUM_THREADS=1
mkdir -p "$folder"

run() {  # name, scheme, element, time step, further settings
  local name=$1 scheme=$2 element=$3 step=$4
  shift 4
  grep -qs '"status": "\(stopped\|completed\)"' "$folder/$name/summary.json" && return
  local settings=()
  for setting in "$@"; do settings+=(--set "$setting"); done
  "$ixos" "$root/xml/strip.xml" --quiet --output "$folder/$name" --set "Time Integrator/Type=$scheme" \
    --set "Interactions/Wall/Contact Element=$element" --set "Time Integrator/Time Step Control/Time Step=$step" \
    --set "Output/Fields Time Interval=0" "${settings[@]}" "${arguments[@]}" >"$folder/$name.log" 2>&1 || cat "$folder/$name.log"
  echo "$name"
}

declare -A schemes=([newmark]="Newmark" [bathe]="Bathe Composite" [composite]="Gautam-Sauer Composite"
                    [avf]="Average Vector Field")
for step in 1 0.1 0.05; do
  for element in Q1C1 Q1C2 Q1C4; do
    for scheme in newmark bathe composite avf; do
      run "$scheme-$element-$step" "${schemes[$scheme]}" $element $step
    done
  done
done
for element in Q1C3 Q1CH; do
  for scheme in newmark bathe composite avf; do
    run "$scheme-$element-1" "${schemes[$scheme]}" $element 1
  done
done
run static-Q1C4-0.5 Static Q1C4 0.5
for scheme in composite newmark bathe; do
  run "$scheme-Q1C4-0.01" "${schemes[$scheme]}" Q1C4 0.01
done
# Mesh refinement of the peak force, to t = 60.
for element in Q1C1 Q1C2 Q1C4; do
  for division in 80,4 160,8 320,16 640,32; do
    run "mesh-$element-${division%,*}" Static $element 0.5 "Mesh/Box/Divisions={$division}" \
      "Time Integrator/Time Step Control/Final Time=60"
  done
done
