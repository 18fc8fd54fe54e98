#!/usr/bin/python3
"""Verifies the numbers of docs/cookbook/waviness. IXOS_DRIVER names the driver (default: that of the release build)."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

STUDY = recipe.study("waviness")


class WavinessTest(unittest.TestCase):
    def test_the_pull_off(self):
        known = {row["quantity"]: row["value"] for row in recipe.reference("waviness")}
        with tempfile.TemporaryDirectory(prefix="ixos-waviness-") as folder:
            pull = STUDY.pull(1.0, folder)
        self.assertAlmostEqual(STUDY.ALPHA, 0.5, delta=1e-4)
        self.assertAlmostEqual(pull.pull_off / known["pull-off"], 1, delta=0.01)
        self.assertAlmostEqual(pull.pull_off_width / known["half width"], 1, delta=0.06)


if __name__ == "__main__":
    unittest.main()
