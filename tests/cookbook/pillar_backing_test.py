#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/pillar-backing: compliance by series, and the pull-off force (8 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/pillar_backing_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("pillar-backing")


class Backing(unittest.TestCase):
    def small(self, height, **given):
        with tempfile.TemporaryDirectory() as folder:
            return study.small(height, folder + "/run", **given)

    def test_the_compliance_grows_with_the_height_as_that_of_a_bar(self):
        rows = {int(row["height"]): row for row in recipe.reference("pillar-backing")}
        found = {height: self.small(height) for height in (600, 1200, 2400)}
        for first, second in ((600, 1200), (1200, 2400)):
            grown = rows[second]["bar"] - rows[first]["bar"]
            self.assertAlmostEqual((found[second] - found[first]) / grown, 1, delta=0.002)
        for height, value in found.items():
            self.assertLess(value, rows[height]["bound"])
            self.assertGreater(value - rows[height]["bar"], 0.8 * (rows[height]["bound"] - rows[height]["bar"]))

    def test_other_cells_of_either_part_change_little(self):
        given = self.small(600)
        for other in ({"divisions": 45}, {"backing": 75}, {"matching": True}):
            self.assertLess(abs(self.small(600, **other) / given - 1), 0.01)

    def test_the_pull_off_force_does_not_depend_on_the_backing(self):
        with tempfile.TemporaryDirectory() as folder:
            run = recipe.run("pillar-backing", study.settings(600), folder + "/run")
        self.assertLess(abs(study.pull_off(run) / study.FULL_FORCE - 1), 0.03)
        self.assertLess(abs(run["reaction_backing_top_y"][-1]), 1e-6 * study.FULL_FORCE)  # it has come off


if __name__ == "__main__":
    unittest.main()
