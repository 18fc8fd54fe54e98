#!/usr/bin/python3
"""Verifies the numbers of docs/cookbook/jkr. IXOS_DRIVER names the driver (default: that of the release build)."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

STUDY = recipe.study("jkr")


class JkrTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="ixos-jkr-")
        self.addCleanup(self.folder.cleanup)

    def test_the_sphere_s_pull_off_follows_the_transition(self):
        for known in recipe.reference("jkr"):
            with self.subTest(tabor=known["tabor"]):
                pull = STUDY.sphere(known["tabor"], 1.0, self.folder.name)
                self.assertAlmostEqual(pull.pull_off / STUDY.UNIT / known["pull_off"], 1, delta=0.006)
                self.assertAlmostEqual(pull.pull_off_radius / known["radius"], 1, delta=0.02)

    def test_the_scene_as_it_stands_is_that_of_tabor_number_1(self):
        run, pull = recipe.run("jkr", {}, self.folder.name), STUDY.sphere(1.0, 1.0, self.folder.name + "/same")
        self.assertAlmostEqual(-run["contact_force_y"].min() / pull.pull_off, 1, delta=1e-3)

    def test_two_spheres_are_one_of_half_the_radius_and_half_the_modulus(self):
        known = next(row for row in recipe.reference("jkr") if row["tabor"] == 1)
        pull = STUDY.spheres(1.0, 1.0, self.folder.name)
        self.assertAlmostEqual(2 * pull.pull_off / STUDY.UNIT / known["pull_off"], 1, delta=0.006)
        self.assertAlmostEqual(pull.pull_off_radius / (known["radius"] / 2 ** 0.5), 1, delta=0.03)

    def test_a_cylinder_of_tabor_number_5_is_one_of_johnson_kendall_and_roberts(self):
        known, pull = STUDY.jkr_cylinder(5.0), STUDY.cylinder(5.0, 1.0, self.folder.name)
        self.assertAlmostEqual(pull.pull_off / known[0], 1, delta=0.01)
        self.assertAlmostEqual(pull.pull_off_radius / known[1], 1, delta=0.03)


if __name__ == "__main__":
    unittest.main()
