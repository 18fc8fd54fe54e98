#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/pillar: pull-off with a small, a middling and a large defect (4 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/pillar_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("pillar")


class PullOff(unittest.TestCase):
    def check(self, defect, tolerance):
        row = next(row for row in recipe.reference("pillar") if row["defect"] == defect)
        with tempfile.TemporaryDirectory() as folder:
            run = recipe.run("pillar", study.settings(defect, steps=100), folder + "/run")
            force = study.pull_off(run)
        self.assertLess(abs(force / row["pull_off"] - 1), tolerance)
        self.assertLess(abs(run["reaction_top_y"][-1]), 1e-6 * force)  # it has come off

    def test_a_small_defect_costs_its_area_only(self):
        self.check(5, 1e-6)

    def test_larger_defects_grow_as_cracks(self):
        self.check(40, 0.03)
        self.check(120, 0.03)

    def test_the_reference_has_the_limits_of_strength_and_of_griffith(self):
        dugdale = study.dugdale
        self.assertEqual(dugdale.pull_off(1), dugdale.strength(1))
        # The root of 1 - (1 - q)^2 is that of 2 q, 1 - q/4 of it for small q.
        q = dugdale.size(250)
        self.assertAlmostEqual(dugdale.pull_off(250) / dugdale.griffith(250), 1 - q / 4, delta=q**2)


if __name__ == "__main__":
    unittest.main()
