#!/usr/bin/python3
"""Prints the energies of steady peeling for each area that came off, from the history of runs of bilayer-peel.xml.

    docs/tutorials/bilayer-peel/balance.py RESULTS..."""
import sys

import ixos
import numpy as np

PARTS = {"adhesion": "contact_energy", "viscoelastic": "dissipated_viscoelasticity_of_soft",
         "friction": "dissipated_friction_of_Adhesion", "elastic": "elastic_energy"}


def balance(history):
    """Returns the mean force [N/m], the work and its parts [J/m^2] while 60 to 36 per cent of the bond are left."""
    bonded = history["contact_measure_Adhesion"]
    steady = (bonded < 0.6 * bonded[0]) & (bonded > 0.36 * bonded[0])

    def slope(column):  # of a straight line through all rows
        return np.polyfit(bonded[0] - bonded[steady], history[column][steady], 1)[0]

    parts = {name: slope(column) for name, column in PARTS.items() if column in history.dtype.names}
    return np.mean(history["reaction_end_y"][steady]), slope("external_work"), parts


if __name__ == "__main__":
    for folder in sys.argv[1:]:
        force, work, parts = balance(ixos.results(folder).history)
        print(f"{folder}: force {force:.4f} N/m, force (1 - cos 45) {force * (1 - 0.5**0.5):.5f} J/m^2")
        print(f"  work {work:.5f} =", " + ".join(f"{name} {value:.5f}" for name, value in parts.items()),
              f"+ rest {work - sum(parts.values()):.0e} J/m^2")
