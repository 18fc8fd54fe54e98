#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/mems-beam: pull-in of a cantilever and of a bridge (2 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/mems_beam_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("mems-beam")

STEP = 0.004  # [um]: the resolution of the gap


class PullIn(unittest.TestCase):
    def measure(self, beam, voltage):
        rows = recipe.reference("mems-beam")
        row = next(row for row in rows if (row["beam"], row["voltage"]) == (beam, voltage))
        with tempfile.TemporaryDirectory() as folder:
            run, gap, deflection = study.measure(row, STEP, pathlib.Path(folder))
            last = int((run["min_gap"] < study.LAYER).argmax()) - 1
            after = run["min_gap"][last + 1:]
        return row, gap, deflection, after

    def check(self, beam, voltage):
        row, gap, deflection, after = self.measure(beam, voltage)
        self.assertLess(abs(gap / row["pull_in_gap"] - 1), 2e-3)
        # The deflection grows as a square root before pull-in: the last step stays below.
        self.assertLess(deflection, 1.005 * row["deflection"])
        self.assertGreater(deflection, 0.85 * row["deflection"])
        self.assertTrue((after < study.LAYER).all() and (after > 0.9 * study.LAYER).all())  # the layer holds the beam

    def test_a_cantilever_is_pulled_in_at_the_gap_of_the_beam_equation(self):
        self.check("cantilever", 20)

    def test_the_tension_of_a_bridge_delays_its_pull_in(self):
        self.check("bridge", 100)

    def test_the_beam_equation_has_the_published_loads(self):
        # Osterberg and Senturia 1997 without fringing fields: 1.68 and 70.1
        self.assertAlmostEqual(study.beam_theory.pull_in("cantilever")[0], 1.681, delta=1e-3)
        self.assertAlmostEqual(study.beam_theory.pull_in("bridge")[0], 70.1, delta=0.05)


if __name__ == "__main__":
    unittest.main()
