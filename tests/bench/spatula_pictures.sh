#!/bin/bash
# Draws the pictures of docs/results/spatula.md: free vibration (six minutes on one core), and peeling on the full mesh,
# which takes hours for each scheme.
#   tests/bench/spatula_pictures.sh FOLDER [IMAGES [IXOS [ARGUMENTS]]]    see pictures.sh
. "$(dirname "${BASH_SOURCE[0]}")/pictures.sh"

"$root/tests/bench/spatula_damping.sh" "$runs/damping" 1500 "$ixos" "${arguments[@]}"
tight="Nonlinear Solver/Tolerance=1e-9"
run composite spatula-stiff "$step/Final Time=190" "$tight"
run bathe-half spatula-stiff "$step/Final Time=190" "$tight" "Time Integrator/Type=Bathe Composite" \
  "Mesh/Spatula/Target Cells=14300"
schemes=("Average Vector Field" "Bathe Composite" "Newmark" "Gautam-Sauer Composite")
for scheme in "${schemes[@]}"; do run "$scheme" spatula-stiff "$step/Final Time=160" "Time Integrator/Type=$scheme"; done

cd "$runs"
"$plot/vibration.py" damping/Newmark-{0,0.001,0.004,0.02,0.1} --output "$images/spatula-damping"
"$plot/vibration.py" damping/{Newmark,Bathe}-{0,0.004} --output "$images/spatula-damping-schemes"
"$plot/fields.py" composite --times 0,30,60,90,110,130,140,150,160 --range=-0.125,0.25 --output "$images/spatula"
"$plot/peeling.py" composite bathe-half --against applied --unit 2,nN --output "$images/spatula-force"
"$plot/peeling.py" composite bathe-half --kinetic --output "$images/spatula-kinetic"
"$plot/peeling.py" "${schemes[@]}" --against applied --unit 2,nN --zoom 15,40,7.5,10 --zoom 120,150 \
  --output "$images/spatula-schemes-force"
"$plot/peeling.py" "${schemes[@]}" --kinetic --zoom 140,160 --output "$images/spatula-schemes-kinetic"
