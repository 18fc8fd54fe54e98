#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/spatula: the force of xml/spatula.xml is largest late in the peeling, on a pad of
a quarter of the size (50 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/spatula_test.py"""
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("spatula")
beam = study.beam
import convergence  # noqa: E402 (beside the study)
import schemes  # noqa: E402


class History(dict):
    """Columns of a run that are given by formulas."""

    def energy_error(self):
        return self["error"]

    def reaction(self):
        return "reaction_shaft end_z", self["time"], self["force"]

    @staticmethod
    def applied(times):
        return times


class PullOffForce(unittest.TestCase):
    def test_the_shapes_are_those_of_the_scenes(self):
        def changes(scene):
            root = ElementTree.parse(recipe.ROOT / "xml" / scene).getroot()
            shape = root.find("ParameterList[@name='Mesh']/ParameterList[@name='Spatula']")
            return {entry.get("name"): float(entry.get("value")) for entry in shape}

        self.assertEqual(changes("spatula.xml").items() - changes("spatula-stiff.xml").items(),
                         beam.LATE.items() - beam.STIFF.items())

    def test_the_force_is_largest_late_in_the_peeling(self):
        scale = 0.25
        with tempfile.TemporaryDirectory() as folder:
            run = recipe.run("spatula", study.settings(beam.LATE, scale), folder + "/run")
            found = study.measured(run, scale, beam.LATE)
        (first, _), (late, lift) = found["first"], found["late"]
        self.assertGreater(late, 1.5 * first)
        self.assertGreater(lift, 0.5 * found["free"])
        self.assertLess(abs(late / 8 - 1), 0.1, "the paper's 8 nN")
        expected = study.predicted("late", scale)
        self.assertLess(abs(late / expected["late"][0] - 1), 0.12)
        self.assertLess(abs(first / expected["first"][0] - 1), 0.12)
        self.assertLess(found["balance"], 1e-3)
        # All of the pad's work of adhesion, and what the snap at the end dissipates.
        self.assertGreater(found["work"] * scale**2, 0.98 * recipe.WORK * self.area(scale))

    def area(self, scale):
        line = beam.Beam(beam.scaled(beam.LATE, scale), 0.25)
        return line.pad_area.sum()

    def test_the_beams_first_peak_is_larger_with_the_stiff_shape_only(self):
        for name in ("stiff", "late"):
            shape = beam.SHAPES[name]
            found = beam.measures(*beam.peel(shape), shape["Pad Length"])
            for peak in ("first", "late"):
                expected, _ = study.predicted(name)[peak]
                self.assertLess(abs(study.NANONEWTONS * found[peak][0] / expected - 1), 2e-3)
            self.assertEqual(found["first"][0] < found["late"][0], name == "late")


class Measures(unittest.TestCase):
    def test_energies_count_from_the_moment_when_the_wall_lets_go(self):
        time = np.arange(0, 71.0)
        run = History({"time": time, "kinetic_energy": np.where(time == 12, 99, time), "contact_measure": time < 10,
                       "error": np.where(time < 10, 1e-3, 4.0), "external_work": time})
        free, top, place, soon, late, before, whole = schemes.swung(run, 1)
        self.assertEqual((free, top, place, late), ("10.0", "99.0", "12.0", "60.00"))
        self.assertAlmostEqual(float(soon), 20 + 87 / 20, places=2)
        self.assertEqual((before, whole), ("1e-05", "6e-02"))

    def test_a_sine_upon_a_slope_ripples_by_its_amplitude(self):
        lift = np.arange(0, 200, 0.5)
        run = History({"time": lift, "force": (1 + lift / 1e3 + 0.1 * np.sin(2 * np.pi * lift / 4)) / study.NANONEWTONS})
        mean = 1 + np.mean(convergence.BETWEEN) / 1e3
        expected = 0.1 / np.sqrt(2) / mean
        self.assertAlmostEqual(convergence.ripple(run, 1), expected, delta=0.1 * expected)

    def test_the_smooth_peak_is_that_of_the_curve_on_which_a_ripple_lies(self):
        lift = np.arange(0, 200, 0.5)
        force = 4 - ((lift - 150) / 100)**2 + 0.1 * np.sin(2 * np.pi * lift / 3)
        peak, place = convergence.smooth_peak(History({"time": lift, "force": force}), 1)
        self.assertAlmostEqual(peak, 4 * study.NANONEWTONS, delta=0.02)
        self.assertAlmostEqual(place, 150, delta=5)


if __name__ == "__main__":
    unittest.main()
