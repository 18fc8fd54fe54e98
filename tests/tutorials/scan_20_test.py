#!/usr/bin/python3
"""Tests the numbers of docs/tutorials/scan-20: both limits, and that a scan that goes on repeats no run (7 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/tutorials/scan_20_test.py

ixos-study stands beside the driver."""
import csv
import math
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
import tutorial

STRENGTH = "Interactions/Adhesion/Smooth Dugdale/Strength"
FOOT = math.pi * 10**2  # [um^2]
STUDY = pathlib.Path(tutorial.recipe.DRIVER).with_name("ixos-study")

limits = tutorial.program("scan-20", "limits")


class Limits(unittest.TestCase):
    def pull_off(self, strength, start):
        settings = {"Mesh/Box/Divisions": "{30, 16}", STRENGTH: strength, tutorial.STEPS + "Time Step": 0.001,
                    "Histories/Pull/Expression/Value": f"{start} + t"}
        with tempfile.TemporaryDirectory() as folder:
            history = tutorial.run("scan-20", settings, folder + "/run")
        return np.nanmax(history["reaction_top_y"][1:])  # in row 0 the top alone has moved

    @unittest.skipUnless(limits, "the Python module ixos is not there")
    def test_strong_bonds_follow_the_exponent_of_the_corner(self):
        exponent = limits.exponent(0.49)
        k, x = 3 - 4 * 0.49, (exponent + 1) / 2  # Williams' condition
        self.assertLess(abs(k * math.sin(x * math.pi / 2)**2 - (k + 1)**2 / 4 + x * x), 1e-9)
        weak, strong = self.pull_off(0.12, 0.96), self.pull_off(0.3, 1.165)
        self.assertLess(abs(math.log(strong / weak) / math.log(0.3 / 0.12) / exponent - 1), 0.02)

    @unittest.skipUnless(STUDY.exists(), "ixos-study is not built")
    def test_a_scan_of_weak_bonds_has_their_strength_and_goes_on_with_more_values(self):
        with tempfile.TemporaryDirectory() as folder:
            def scan(values):
                command = [str(STUDY), "--scan", str(tutorial.path("scan-20", "scan-20.xml")), "--jobs", "2",
                           "--output", folder + "/scan", "--vary", f"{STRENGTH}={values}",
                           "--set", "Mesh/Box/Divisions={12, 8}", "--set", tutorial.STEPS + "Time Step=0.04"]
                done = subprocess.run(command, env=tutorial.recipe.ENVIRONMENT, capture_output=True, text=True,
                                      check=True)
                with open(folder + "/scan/scan.csv", newline="", encoding="utf-8") as file:
                    return done.stdout.count("(reused)"), list(csv.DictReader(file))

            self.assertEqual(scan("0.01:0.02:2:log")[0], 0)
            reused, rows = scan("0.01:0.04:3:log")
            self.assertEqual(reused, 2)
            self.assertEqual([float(row["Strength"]) for row in rows], [0.01, 0.02, 0.04])
            for row in rows:
                self.assertLess(abs(float(row["peak reaction_top_y"]) / (float(row["Strength"]) * FOOT) - 1), 1e-6)


if __name__ == "__main__":
    unittest.main()
