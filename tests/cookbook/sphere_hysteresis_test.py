#!/usr/bin/python3
"""Verifies the numbers of docs/cookbook/sphere-hysteresis. IXOS_DRIVER names the driver (default: that of the release
build)."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

STUDY = recipe.study("sphere-hysteresis")
KNOWN = {row["speed"]: row["pull_off"] for row in recipe.reference("sphere-hysteresis")}


class SphereHysteresisTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="ixos-sphere-hysteresis-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.pressed = STUDY.press(cls.folder / "press")
        cls.pulls = {speed: STUDY.Pull(speed, cls.pressed, cls.folder / f"{speed:g}") for speed in (0.001, 0.1, 100.0)}

    def test_the_pull_off_force_follows_that_of_a_viscoelastic_half_space(self):
        for speed, pull in self.pulls.items():
            with self.subTest(speed=speed):
                self.assertAlmostEqual(pull.pull_off / KNOWN[speed], 1, delta=0.02)

    def test_without_the_branch_the_pull_off_force_is_that_of_tabor_number_3(self):
        self.assertAlmostEqual(STUDY.elastic(self.folder / "elastic") / STUDY.SLOW, 1, delta=0.01)

    def test_the_account_of_the_loop_closes_with_shorter_steps(self):
        finer = STUDY.Pull(0.1, self.pressed, self.folder / "finer", STUDY.STEP / 2)
        pull = self.pulls[0.1]
        self.assertGreater(pull.dissipated, 0.8 * pull.work)
        self.assertGreater(min(pull.jump, finer.jump), 1)
        self.assertLess(abs(finer.rest), 0.7 * abs(pull.rest))
        self.assertLess(abs(finer.rest), 0.05 * pull.work)


if __name__ == "__main__":
    unittest.main()
