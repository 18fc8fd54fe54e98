#!/usr/bin/python3
"""Verifies the numbers of docs/cookbook/hertz. IXOS_DRIVER names the driver (default: that of the release build)."""
import math
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

STUDY = recipe.study("hertz")


class HertzTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="ixos-hertz-")
        self.addCleanup(self.folder.cleanup)

    def test_a_sphere(self):
        known = {row["quantity"]: row["value"] for row in recipe.reference("hertz") if row["body"] == "sphere"}
        dent = STUDY.Dent({}, self.folder.name)
        self.assertAlmostEqual(dent.force[-1] / known["force"], 1, delta=0.01)
        self.assertAlmostEqual(dent.radius[-1] / known["contact radius"], 1, delta=0.01)
        self.assertAlmostEqual(dent.pressure.max() / known["largest pressure"], 1, delta=0.01)

    def test_a_cylinder(self):
        dent = STUDY.Dent(STUDY.CYLINDER, self.folder.name)
        width, pressure = STUDY.cylinder(dent.force[-1])
        self.assertAlmostEqual(dent.radius[-1] / width, 1, delta=0.01)
        self.assertAlmostEqual(dent.pressure.max() / pressure, 1, delta=0.01)

    def test_a_rigid_body_before_an_adhesive_sphere_has_the_integral_of_the_law(self):
        gap, force, expected = STUDY.rigid(self.folder.name)
        np.testing.assert_allclose(force, expected, rtol=1e-6)
        bradley = -2 * np.pi * (STUDY.RADIUS + gap[-1]) * recipe.WORK
        self.assertAlmostEqual(force[-1] / bradley, 1, delta=1e-5)  # the edge's share
        self.assertEqual(force.argmin(), len(force) - 1)

    def test_a_rigid_body_before_an_adhesive_cylinder_has_the_integral_of_the_law(self):
        gap, force, expected = STUDY.rigid_section(self.folder.name)
        np.testing.assert_allclose(force, expected, rtol=1e-6)
        known = next(row["value"] for row in recipe.reference("hertz") if row["body"] == "rigid cylinder")
        self.assertAlmostEqual(force[-1] / known, 1, delta=1e-6)
        # Derjaguin's parabola has the integral in closed form, and differs by about the gap over the radius.
        power = [math.sqrt(2 * STUDY.RADIUS * math.pi) * math.gamma(n - 0.5) / math.gamma(n) for n in (9, 3)]
        scale, least = 8 * recipe.WORK / (3 * recipe.EQUILIBRIUM_GAP), gap[0]
        ratio = recipe.EQUILIBRIUM_GAP / least
        parabola = scale * least ** 0.5 * (power[0] * ratio ** 9 - power[1] * ratio ** 3)
        self.assertAlmostEqual(force[0] / parabola, 1, delta=3 * least / STUDY.RADIUS)


if __name__ == "__main__":
    unittest.main()
