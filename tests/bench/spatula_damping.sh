#!/bin/bash
# Free vibration of the spatula for several dampings: the bent state, then each run from its release to 250 T0. Finished
# runs are not repeated. CELLS is the mesh's Target Cells; 1500 take six minutes on one core.
#   tests/bench/spatula_damping.sh FOLDER [CELLS [IXOS [ARGUMENTS]]]      ARGUMENTS: further ones of ixos, as of --set
# Folders: bent, Newmark-0 to Newmark-6, Bathe-0 and Bathe-0.004.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:?"usage: spatula_damping.sh FOLDER [CELLS [IXOS [ARGUMENTS]]]"}
cells=${2:-14300}
ixos=${3:-$root/build/release/drivers/ixos}
arguments=("${@:4}")
export OPENBLAS_NUM_THREADS=1
mkdir -p "$folder"
failed=0

run() {  # name, further arguments
  local name=$1
  shift
  grep -qs '"status": "completed"' "$folder/$name/summary.json" && return
  "$ixos" "$root/xml/spatula-vibration.xml" --quiet --output "$folder/$name" --set "Mesh/Spatula/Target Cells=$cells" \
    "${arguments[@]}" "$@" >"$folder/$name.log" 2>&1 || { cat "$folder/$name.log"; failed=1; }
  echo "$name"
}

bend="Boundary Conditions/Bend"
run bent --set "Time Integrator/Type=Static" --set "Time Integrator/Time Step Control/Final Time=0" \
  --set "$bend/Node Set=tip" --set "$bend/Components=z" --set "$bend/History=Bend" --set "Output/Reactions={tip}"
for damping in 0 0.001 0.004 0.02 0.1 6; do
  run "Newmark-$damping" --restart "$folder/bent" --set "Materials/Keratin/Stiffness Damping=$damping"
done
for damping in 0 0.004; do
  run "Bathe-$damping" --restart "$folder/bent" --set "Materials/Keratin/Stiffness Damping=$damping" \
    --set "Time Integrator/Type=Bathe Composite"
done
exit $failed
