#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/two-balls: the energy at the start, sticking, rebound and what is kept (25 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/two_balls_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("two-balls")
KNOWN = {row["quantity"]: row["value"] for row in recipe.reference("two-balls")}


def run(settings, until):
    with tempfile.TemporaryDirectory() as folder:
        return recipe.run("two-balls", {**settings, recipe.STEPS + "Final Time": until}, folder + "/run")


class TwoBalls(unittest.TestCase):
    def test_fast_balls_rebound_like_one_ball_before_a_wall(self):
        pair = run(study.balls(40.0, 0.0, 0.002), 0.2)
        wall = run({**study.balls(40.0, 0.0), **study.before_a_wall()}, 0.2)
        self.assertLess(abs(pair["contact_energy"][0] / KNOWN["energy at the start"] - 1), 2e-3)
        self.assertGreater(study.restitution(pair, 2), 0.5)
        self.assertAlmostEqual(study.restitution(pair, 2), study.restitution(wall), delta=0.1)

    def test_slow_balls_off_centre_stick_and_keep_energy_and_momentum(self):
        pair = run(study.balls(10.0, 4.0, 0.002), 0.3)
        momentum = 2 * study.formulas.MASS * 10
        self.assertLess(pair["contact_energy"][-1], KNOWN["least energy"] / 2)
        self.assertLess(pair.energy_error().max(), 1e-4 * recipe.WORK)
        self.assertLess(np.hypot(pair["linear_momentum_x"], pair["linear_momentum_y"]).max(), 1e-11 * momentum)
        angular = pair["angular_momentum_z"]
        self.assertLess(abs(angular - angular[0]).max(), 5e-3 * abs(angular[0]))


if __name__ == "__main__":
    unittest.main()
