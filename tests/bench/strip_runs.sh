#!/bin/bash
# The runs in the pictures of docs/results/strip.md: schemes, contact elements and time steps, and a static run. Finished
# runs are not repeated. About ten minutes on one core.
#   tests/bench/strip_runs.sh FOLDER [IXOS [ARGUMENTS]]      ARGUMENTS: further ones of ixos, as of --set
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:?"usage: strip_runs.sh FOLDER [IXOS [ARGUMENTS]]"}
ixos=${2:-$root/build/release/drivers/ixos}
arguments=("${@:3}")
export OPENBLAS_NUM_THREADS=1
mkdir -p "$folder"

run() {  # name of the scheme, scheme, element, time step
  local name=$1-$3-$4
  grep -qs '"status": "\(stopped\|completed\)"' "$folder/$name/summary.json" && return
  "$ixos" "$root/xml/strip.xml" --quiet --output "$folder/$name" --set "Time Integrator/Type=$2" \
    --set "Interactions/Wall/Contact Element=$3" --set "Time Integrator/Time Step Control/Time Step=$4" \
    --set "Output/Fields Time Interval=0" "${arguments[@]}" >"$folder/$name.log" 2>&1 || cat "$folder/$name.log"
  echo "$name"
}

run newmark Newmark Q1C4 0.01
run bathe "Bathe Composite" Q1C4 0.01
run static Static Q1C4 0.5
for step in 0.01 0.05 0.1; do run composite "Gautam-Sauer Composite" Q1C4 $step; done
for step in 0.05 0.1 1; do run composite "Gautam-Sauer Composite" Q1C1 $step; done
run composite "Gautam-Sauer Composite" Q1C2 0.05
