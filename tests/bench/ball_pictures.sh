#!/bin/bash
# Draws the picture of the schemes in docs/results/ball.md. Half a minute on one core.
#   tests/bench/ball_pictures.sh FOLDER [IMAGES [IXOS [ARGUMENTS]]]       see pictures.sh
. "$(dirname "${BASH_SOURCE[0]}")/pictures.sh"

schemes=("Newmark" "Bathe Composite" "Gautam-Sauer Composite" "Average Vector Field" "Energy-Momentum"
         "Generalized-Alpha" "HHT-Alpha" "Midpoint" "Central Difference")
for scheme in "${schemes[@]}"; do
  run "$scheme" ball "Time Integrator/Type=$scheme" || [ $? -eq 3 ] # some diverge
done
cd "$runs"
"$plot/history.py" "${schemes[@]}" --output "$images/ball-schemes"
