#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/film-peel: steady forces at 90 and 30 degrees, and with friction (10 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/film_peel_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("film-peel")


class SteadyForce(unittest.TestCase):
    def measure(self, angle):
        row = next(row for row in recipe.reference("film-peel") if row["angle"] == angle)
        with tempfile.TemporaryDirectory() as folder:
            return row, *study.steady_force(recipe.run("film-peel", study.settings(angle), folder + "/run"))

    def test_at_90_degrees_the_force_is_kendalls(self):
        row, force, least, largest = self.measure(90)
        self.assertLess(abs(force / row["kendall"] - 1), 0.01)
        self.assertLess(largest - least, 0.01 * force)

    def test_a_film_that_slides_needs_the_force_of_the_sliding_formula(self):
        row, force, least, largest = self.measure(30)
        self.assertLess(abs(force / row["sliding"] - 1), 0.01)
        self.assertLess(abs(force / row["finite_strain"] - 1), 2e-3)
        self.assertGreater(force / row["kendall"], 1.05)
        self.assertLess(largest - least, 0.01 * force)

    def test_friction_adds_what_it_dissipates_to_kendalls_balance(self):
        angle, stress = 30, 0.005
        with tempfile.TemporaryDirectory() as folder:
            run = recipe.run("film-peel", study.with_friction(angle, stress), folder + "/run")
            force, least, largest = study.steady_force(run)
            lost, slipped = study.dissipated(run), study.slip_zone(run, angle)
        formulas = study.formulas
        self.assertLess(abs(force / formulas.kendall(angle, formulas.WORK + lost) - 1), 0.02)
        # at least the energy of the film's stretch, which sets the sliding film apart from Kendall's
        self.assertGreater(lost, force**2 * 0.75 / (2 * formulas.STIFFNESS))
        self.assertLess(largest - least, 0.01 * force)
        zone = formulas.slip_zone(angle, force, stress, stress / study.ELASTIC_SLIP)
        self.assertLess(abs(slipped - zone), formulas.THICKNESS)


if __name__ == "__main__":
    unittest.main()
