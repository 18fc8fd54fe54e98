#!/usr/bin/python3
"""Verifies the numbers of docs/cookbook/restitution. IXOS_DRIVER names the driver (default: that of the release
build)."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

STUDY = recipe.study("restitution")


def known(series, speed, time=0.0):
    return next(row for row in recipe.reference("restitution") if row["series"] == series and
                row["speed"] == speed and row["relaxation_time"] == time)


class RestitutionTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="ixos-restitution-")
        self.addCleanup(self.folder.cleanup)

    def test_without_adhesion_an_elastic_ball_loses_what_its_vibration_takes(self):
        row, run = known("waves", 10.0), STUDY.impact(10.0, self.folder.name, steps=100)
        self.assertAlmostEqual((run.lost / run.before) / (1 - row["restitution"] ** 2), 1, delta=0.25)
        self.assertLess(run.error, 1e-11)

    def test_a_slow_contact_lasts_as_long_as_that_of_hertz(self):
        run = STUDY.impact(1.0, self.folder.name, steps=100)
        self.assertAlmostEqual(run.contact_time / known("waves", 1.0)["contact_time"], 1, delta=0.05)

    def test_viscosity_takes_what_the_theory_of_the_half_space_says(self):
        row, run = known("viscosity", 1.0, 3.0), STUDY.impact(1.0, self.folder.name, 3.0, steps=100)
        self.assertAlmostEqual(run.restitution / row["restitution"], 1, delta=0.015)
        self.assertLess(run.error, 1e-11)
        # The rest is vibration: much less than 1 per cent.
        self.assertAlmostEqual(run.dissipated, 1 - run.restitution ** 2, delta=0.01)

    def test_a_slow_ball_sticks_and_a_faster_one_rebounds(self):
        sticking = next(row["speed"] for row in recipe.reference("restitution") if row["series"] == "adhesion")
        slow = STUDY.adhesive_impact(0.9 * sticking, self.folder.name)
        self.assertEqual(slow.restitution, 0)
        fast = STUDY.adhesive_impact(0.2, self.folder.name)
        self.assertAlmostEqual(fast.restitution, (1 - (sticking / 0.2) ** 2) ** 0.5, delta=0.05)
        self.assertLess(fast.error, 1e-9)


if __name__ == "__main__":
    unittest.main()
