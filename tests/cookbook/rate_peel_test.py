#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/rate-peel: both plateaus, the largest force and the energy balance (11 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/rate_peel_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("rate-peel")
RATIO = 1.4  # of the gaps in a step; the page has 1.2
EXPECTED = {row["speed"]: row["force"] for row in recipe.reference("rate-peel")}


def measure(settings):
    with tempfile.TemporaryDirectory() as folder:
        run = recipe.run("rate-peel", settings, folder + "/run")
        run.energy_errors = run.energy_error()
        return run


class PeelForce(unittest.TestCase):
    def assert_balanced(self, run):
        """Work is stored and dissipated energy. The force is that of equilibrium, the dissipation that of the
        branches: the sum would be wrong by the error of either."""
        work, dissipated, stored = study.balance(run)
        self.assertLess(abs(work - recipe.WORK - dissipated - stored), 1e-10)
        self.assertLess(run.energy_errors.max(), 1e-10 * (run["external_work"].max() + recipe.WORK * study.LENGTH))
        column = run["dissipated_viscoelasticity_of_body"]
        self.assertGreaterEqual(np.diff(column).min(), 0)
        np.testing.assert_allclose(column, run["dissipated_energy"], rtol=1e-14)

    def test_elastic_strips_have_the_closed_forms(self):
        for speed, shear in ((0, study.formulas.SHEAR), (float("inf"), study.formulas.SHEAR + study.formulas.BRANCH)):
            force = study.steady_force(measure(study.elastic(shear, RATIO)))
            self.assertLess(abs(force / EXPECTED[speed] - 1), 2e-3)

    def test_slow_peeling_is_nearly_elastic(self):
        run = measure(study.constant_speed(0.001, RATIO))
        excess = study.steady_force(run) / EXPECTED[0] - 1
        self.assertGreater(excess, 0.01)
        self.assertLess(excess, 0.02)
        self.assert_balanced(run)

    def test_at_a_medium_speed_dissipation_adds_half_of_the_work_of_adhesion(self):
        run = measure(study.constant_speed(0.2, RATIO))
        force = study.steady_force(run)
        self.assertGreater(force / recipe.WORK, 1.43)
        self.assertLess(force / recipe.WORK, 1.51)
        self.assertLess(abs(force / (recipe.WORK + study.balance(run)[1]) - 1), 0.01)
        self.assert_balanced(run)

    def test_fast_peeling_has_the_first_correction_to_the_instantaneous_limit(self):
        run = measure(study.constant_speed(100.0, RATIO))
        force = study.steady_force(run)
        self.assertLess(abs(force / EXPECTED[100] - 1), 3e-3)
        self.assertGreater(force / EXPECTED[float("inf")], 1.003)
        self.assert_balanced(run)


if __name__ == "__main__":
    unittest.main()
