#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/cylinders: the pull-off force at the Tabor number 1 (10 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/cylinders_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("cylinders")


class PullOff(unittest.TestCase):
    def test_two_cylinders_are_one_of_half_the_radius_and_half_the_modulus(self):
        known = next(row for row in recipe.reference("cylinders") if row["tabor"] == 1)
        with tempfile.TemporaryDirectory() as folder:
            pull = study.Pull(1.0, folder + "/run")
        self.assertLess(abs(pull.pull_off / known["pull_off"] - 1), 5e-3)
        self.assertLess(abs(pull.half_width / known["half_width"] - 1), 0.05)
        self.assertLess(pull.pull_off, 0.96 * known["jkr"])


if __name__ == "__main__":
    unittest.main()
