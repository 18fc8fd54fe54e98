#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/stamp: the force of a fast lift, and both outcomes on one wall (20 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/stamp_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("stamp")
RECEIVER = study.WALLS[1]


def run(settings):
    """Runs half as many columns and rows as the page."""
    coarse = {"Mesh/Parts/chip/Box/Divisions": [20, 4], "Mesh/Parts/stamp/Box/Divisions": [38, 13]}
    with tempfile.TemporaryDirectory() as folder:
        return recipe.run("stamp", {**settings, **recipe.QUIET, **coarse, "Output/Fields Interval": 0}, folder + "/run")


class PickAndPrint(unittest.TestCase):
    def test_a_fast_stamp_comes_off_the_chip_with_the_force_of_the_reference(self):
        speeds, forces = study.known()
        self.assertLess(abs(study.largest_force(run(study.alone(10.0))) / forces[speeds == 10][0] - 1), 0.02)

    def test_the_speed_decides_which_bond_opens(self):
        for speed, outcome in ((1.0, "picked up"), (0.02, "printed")):
            self.assertEqual(study.expected(RECEIVER, speed), outcome)
            lift = run(study.on_a_wall(RECEIVER, speed))
            self.assertEqual(study.outcome(lift), outcome)
            self.assertLess(lift.energy_error().max(), 1e-6)
            if outcome == "picked up":  # a stiff chip lets go at the wall's strength
                self.assertLess(abs(study.largest_force(lift) / study.formulas.wall(RECEIVER) - 1), 0.02)


if __name__ == "__main__":
    unittest.main()
