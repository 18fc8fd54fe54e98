#!/usr/bin/python3
"""Tests the numbers of docs/tutorials/mushroom-pillar: strength, flaws, energy and the singularity at the edge (7 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/tutorials/mushroom_pillar_test.py"""
import math
import tempfile
import unittest

import numpy as np
import tutorial
from scipy.optimize import brentq

LAW = "Interactions/Adhesion/Smooth Dugdale/"
STRAIGHT = {"Mesh/Map/X": "10*x"}
WORK, STRENGTH, STEM, CAP = 0.05, 0.1, 10.0, 15.0  # [MPa um], [MPa], [um], [um]


def run(settings):
    with tempfile.TemporaryDirectory() as folder:
        return tutorial.run("mushroom-pillar", settings, folder + "/run")


def pull(settings, cells="{14, 8}", step=0.05):
    return run({"Mesh/Box/Divisions": cells, tutorial.STEPS + "Time Step": step, **settings})


def pull_off(history):
    return np.nanmax(history["reaction_top_y"][1:])  # after a jump at the start the top alone has moved in row 0


def foot(radius):
    return math.pi * radius**2


def singularity(nu):
    """Returns the exponent lambda of the displacement at the corner of a bonded foot: sin(lambda pi/2)^2 =
    ((k + 1)^2/4 - lambda^2)/k, k = 3 - 4 nu (Williams 1952, clamped-free corner of 90 degrees)."""
    k = 3 - 4 * nu
    return brentq(lambda x: math.sin(x * math.pi / 2)**2 - ((k + 1)**2 / 4 - x * x) / k, 0.4, 0.9)


class PullOff(unittest.TestCase):
    def test_a_weak_bond_holds_its_strength_times_the_foot(self):
        force = pull_off(pull({**STRAIGHT, LAW + "Strength": 0.05}))
        self.assertLess(abs(force / (0.05 * foot(STEM)) - 1), 1e-6)

    def test_a_flaw_at_the_rim_weakens_the_straight_pillar_only(self):
        flawless, flawed = (pull_off(pull(settings)) for settings in
                            ({}, {"Interactions/Adhesion/Factor": "x > 14 ? 0 : 1"}))
        self.assertLess(abs(flawed / flawless - 1), 1e-3)
        straight = pull_off(pull({**STRAIGHT, "Interactions/Adhesion/Factor": "x > 9 ? 0 : 1"}, "{20, 8}"))
        self.assertLess(straight, (1 + 1e-9) * STRENGTH * foot(9))
        self.assertGreater(straight, 0.95 * STRENGTH * foot(9))

    def test_the_cap_is_between_the_stem_and_its_strength(self):
        coarse, fine = (pull(dict(), cells) for cells in ("{12, 8}", "{18, 10}"))
        self.assertLess(abs(pull_off(coarse) / pull_off(fine) - 1), 0.01)
        self.assertGreater(pull_off(fine), STRENGTH * foot(STEM))
        self.assertLess(pull_off(fine), STRENGTH * foot(CAP))
        # The foot starts at a gap of 1 nm, within the attraction and the penalty of 100 MPa/um below 2 nm.
        bond = (-WORK + STRENGTH * 1e-3 + 100 / 2 * 1e-3**2) * foot(CAP)
        self.assertLess(abs(fine["contact_energy"][0] / bond - 1), 1e-9)
        # The work of the pull breaks the bond, and the rest is released by the jump.
        rest = fine["external_work"][-1] + bond - fine["dissipated_energy"][-1]
        self.assertLess(abs(fine.summary["jumps"]["released"] / rest - 1), 0.01)
        balance = fine["total_energy"] - fine["external_work"] + fine["dissipated_energy"]
        released = fine["released_energy"]
        self.assertEqual((released[0], released[-1]), (0, fine.summary["jumps"]["released"]))
        self.assertLess(max(abs(balance + released - balance[0])), 0.01 * rest)

    def test_strong_bonds_tear_from_the_edge_by_the_singularity_of_the_corner(self):
        # A cohesive zone much shorter than the foot: the force grows with the strength to the power 2 lambda - 1.
        forces = [pull_off(run(
            {"Mesh/Box/Divisions": "{36, 20}", "Mesh/Map/X": "10*(1 - (exp(6*(1 - x)) - 1)/(exp(6) - 1))",
             "Mesh/Map/Y": "1e-5 + 30*(exp(8*y) - 1)/(exp(8) - 1)", "Materials/PDMS/Model": "Linear Elastic",
             LAW + "Strength": strength, LAW + "Work of Adhesion": "0.5 mJ/m^2",
             "Interactions/Adhesion/Friction/Stiffness": 1e4, "Interactions/Glass/Penalty/Stiffness": 1e4,
             "Interactions/Glass/Penalty/Gap": 2e-5, "Histories/Pull/Expression/Value": f"{start} + t",
             tutorial.STEPS + "Time Step": 0.0005})) for strength, start in ((0.05, 0.325), (0.1, 0.37))]
        expected = 2**(2 * singularity(0.49) - 1)
        self.assertLess(abs(forces[1] / forces[0] / expected - 1), 0.005)


if __name__ == "__main__":
    unittest.main()
