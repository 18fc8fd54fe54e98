#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/afm: jumps of a tip, forces of a scan (3 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/afm_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("afm")


class Jumps(unittest.TestCase):
    STEP = 0.02  # [nm]

    def test_the_tip_jumps_where_the_gradient_of_the_force_is_the_stiffness(self):
        row = recipe.reference("afm")[1]
        with tempfile.TemporaryDirectory() as folder:
            run = study.approach(row["stiffness"], self.STEP, folder + "/run")
            height_in, height_out, pull = study.jumps(run, row["stiffness"])
        self.assertLess(abs(height_in - row["base_in"]), self.STEP)
        self.assertLess(abs(height_out / row["base_out"] - 1), 0.01)
        self.assertLess(abs(pull / row["force_out"] - 1), 0.01)

    def test_the_reference_is_the_curve_of_equilibria(self):
        # At a jump the height of the base has an extreme: its differences on both sides have one sign.
        for stiffness in study.rigid.STIFFNESSES:
            for gap, height in study.rigid.jumps(stiffness):
                sides = [study.rigid.base(gap + change, stiffness) - height for change in (-1e-4, 1e-4)]
                self.assertGreater(sides[0] * sides[1], 0)


class Scan(unittest.TestCase):
    def check(self, file, surface=None):
        with tempfile.TemporaryDirectory() as folder:
            run = study.scan(24, folder + "/run", step=1, surface=surface)
        rows = recipe.reference("afm", file)
        largest = max(abs(row["force_x"]) for row in rows)
        for row in rows:
            at = int(row["path"])
            self.assertEqual(run["time"][at], row["path"])
            self.assertLess(abs(run["contact_force_z"][at] / row["force_z"] - 1), 0.015)
            self.assertLess(abs(run["contact_force_x"][at] - row["force_x"]), 0.015 * largest)

    def test_the_force_on_a_tip_over_waves_is_that_of_the_quadrature(self):
        self.check("rough.csv")

    def test_the_force_over_the_heights_of_a_file_is_that_over_the_surface_behind_them(self):
        self.check("scan.csv", study.SCANNED)

    def test_the_file_is_the_one_that_the_script_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            study.rough.write_scan(pathlib.Path(folder, "again.gsf"))
            again = pathlib.Path(folder, "again.gsf").read_bytes()
        heights = [np.frombuffer(data, "<f4", offset=len(data) - 4 * 32 * 32)
                   for data in (again, (recipe.ROOT / "xml/afm-rough.gsf").read_bytes())]
        self.assertLess(abs(heights[0] - heights[1]).max(), 1e-15)  # [m]; sines are rounded


if __name__ == "__main__":
    unittest.main()
