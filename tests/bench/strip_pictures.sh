#!/bin/bash
# Draws the pictures of docs/results/strip.md, except for the study's. About ten minutes on one core.
#   tests/bench/strip_pictures.sh FOLDER [IMAGES [IXOS [ARGUMENTS]]]      see pictures.sh
. "$(dirname "${BASH_SOURCE[0]}")/pictures.sh"

peel() { # name of the scheme, scheme, element, time step
  run "$1-$3-$4" strip "Time Integrator/Type=$2" "Interactions/Wall/Contact Element=$3" "$step/Time Step=$4" \
    "Output/Fields Time Interval=0"
}

peel newmark Newmark Q1C4 0.01
peel bathe "Bathe Composite" Q1C4 0.01
peel static Static Q1C4 0.5
for length in 0.01 0.05 0.1; do peel composite "Gautam-Sauer Composite" Q1C4 $length; done
for length in 0.05 0.1 1; do peel composite "Gautam-Sauer Composite" Q1C1 $length; done
peel composite "Gautam-Sauer Composite" Q1C2 0.05
run frames strip "Output/Fields Time Interval=1"

cd "$runs"
fine=({newmark,bathe,composite}-Q1C4-0.01)
"$plot/fields.py" frames --times 10,20,30,40,50,60,80,100,115,125,127,128 --range=-0.15,0.15 --output "$images/strip"
"$plot/peeling.py" "${fine[@]}" --zoom 35,42 --zoom 126,128.2 --marks 10,20,30,40,60,80,100,115,125,127 \
  --output "$images/strip-force"
"$plot/peeling.py" "${fine[@]}" --speed --probe P --zoom 60,64 --zoom 126,128.2 --output "$images/strip-speed"
"$plot/peeling.py" composite-{Q1C1,Q1C2,Q1C4}-0.05 --zoom 60,64 --zoom 100,104 --output "$images/strip-elements"
"$plot/peeling.py" composite-Q1C1-{1,0.1,0.05} --reference composite-Q1C4-0.01 --zoom 34,46 --zoom 126,130 \
  --output "$images/strip-steps"
"$plot/peeling.py" static-Q1C4-0.5 composite-Q1C4-0.1 --against displacement --zoom 8,20 --output "$images/strip-static"
