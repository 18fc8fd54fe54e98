#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/gecko-drag: forces on a pad that slides while it is lifted (7 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/gecko_drag_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("gecko-drag")
SHORT = {recipe.STEPS + "Time Step": 1.0, recipe.STEPS + "Final Time": 145.0}
DRAG = 20  # end of the drag


class PullOff(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = {row["stress"]: row for row in recipe.reference("gecko-drag")}
        with tempfile.TemporaryDirectory() as folder:
            cls.runs = {kind: study.drag(kind, stress, SHORT, pathlib.Path(folder, kind))
                        for kind, stress in (("None", 0.0), ("Constant Stress", 0.001), ("Extended Amontons", 0.001))}

    def test_a_pad_without_friction_is_peeled_at_a_right_angle(self):
        along, away = study.forces(self.runs["None"])
        self.assertLess(abs(along), 1e-6)
        self.assertLess(abs(away / self.rows[0]["normal"] - 1), 0.02)

    def test_friction_raises_the_force_as_the_formula_of_a_film_that_slides_says(self):
        for kind in ("Constant Stress", "Extended Amontons"):
            along, away = study.forces(self.runs[kind])
            row = self.rows[0.001]
            self.assertLess(abs(along / row["tangential"] - 1), 0.03, kind)
            self.assertLess(abs(away / row["normal"] - 1), 0.02, kind)
            largest = {name: run["reaction_right_y"].max() for name, run in self.runs.items()}
            self.assertGreater(largest[kind] / largest["None"], 2.8)

    def test_during_the_drag_the_force_is_the_threshold(self):
        run = self.runs["Constant Stress"]
        sliding = (run["time"] > 5) & (run["time"] < DRAG)
        np.testing.assert_allclose(run["reaction_right_x"][sliding], 0.001 * 80, rtol=1e-6)

    def test_the_work_of_the_drag_is_dissipated(self):
        run = self.runs["Constant Stress"]
        end = int(np.argmax(run["time"] >= DRAG))
        slid = run["time"] > 5
        first = int(np.argmax(slid))
        work, lost = (run[name][end] - run[name][first] for name in ("external_work", "dissipated_friction_of_Wall"))
        self.assertLess(abs(work / (0.001 * 80 * (run["time"][end] - run["time"][first])) - 1), 1e-4)
        self.assertLess(abs(lost / work - 1), 1e-4)


if __name__ == "__main__":
    unittest.main()
