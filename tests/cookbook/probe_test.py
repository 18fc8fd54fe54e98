#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/probe: a rigid probe that jumps into contact and out of it (20 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/probe_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("probe")


class Probe(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.run_ = study.probe(folder + "/run")
        cls.found = {**study.loading(cls.run_), **study.unloading(cls.run_)}
        cls.measured = {name: float(np.mean(values)) for name, values in study.measured().items()}

    def near(self, name, tolerance):
        self.assertLess(abs(self.found[name] / self.measured[name] - 1), tolerance, name)

    def test_the_force_after_the_jump_in_is_the_measured_one(self):
        self.near("force_in", 0.1)

    def test_the_jump_out_is_where_it_was_measured(self):
        self.near("pull", 0.02)  # from which the work of adhesion was taken
        self.near("height_out", 0.15)

    def test_the_approach_is_that_of_the_theory_and_the_range_of_the_law(self):
        exact = study.closed_forms()
        for name in ("force_in", "zero_loading"):
            self.assertLess(abs(self.found[name] / exact[name] - 1), 0.04, name)

    def test_the_free_probe_rings_as_a_mass_on_a_spring(self):
        self.assertLess(abs(study.ring(self.run_) / study.jkr.ring() - 1), 0.02)

    def test_the_spring_carries_the_contact_on_the_slow_path(self):
        depth = study.depth(self.run_)
        slow = (self.run_["time"] < 45) & (depth > 0)
        difference = study.force(self.run_) + self.run_["contact_force_y"]
        self.assertLess(np.abs(difference[slow]).max(), 0.002)  # of 1.4: the dashpot and the inertia


class Theory(unittest.TestCase):
    def test_the_closed_forms_are_those_of_the_curve(self):
        for work in study.WORKS.values():
            base, force = study.jkr.depths(work, np.linspace(0.5, 4, 400001))
            self.assertAlmostEqual(force.min(), study.jkr.pull(work), delta=1e-8)
            self.assertAlmostEqual(study.jkr.at_depth(work, study.jkr.zero(work)), 0, delta=1e-6)
            self.assertAlmostEqual(-base.min(), study.jkr.release(work)[0], delta=1e-8)


if __name__ == "__main__":
    unittest.main()
