#!/usr/bin/python3
"""Tests docs/cookbook/crossed-cylinders: the force before contact, at right angles and at 60 degrees.

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/crossed_cylinders_test.py"""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("crossed-cylinders")


class Force(unittest.TestCase):
    def test_it_is_derjaguins_at_both_angles(self):
        for angle in 90.0, 60.0:
            with self.subTest(angle=angle), tempfile.TemporaryDirectory() as folder:
                distance, force = study.approach(100.0, angle, folder + "/run", last=0.2)
                for at, measured in zip(distance, force):
                    known = study.derjaguin(at, 100.0, angle)
                    # The law's range is 5 % of the radius.
                    self.assertGreater(measured / known, 1.0)
                    self.assertLess(measured / known, 1.04)


if __name__ == "__main__":
    unittest.main()
