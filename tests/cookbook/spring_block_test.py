#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/spring-block: the spring's force, and the way of a block that is pushed (1 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/spring_block_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("spring-block")
rigid = study.rigid


class Block(unittest.TestCase):
    def test_the_force_of_the_spring_swings_about_the_threshold(self):
        for row in recipe.reference("spring-block"):
            speed = row["speed"]
            with tempfile.TemporaryDirectory() as folder:
                run = study.pulled(speed, folder + "/run")
            time, force = study.spring_force(run, speed)
            swing = rigid.swing(speed)
            self.assertLess(np.abs(force - rigid.spring_force(time, speed)).max(), 0.01 * swing, speed)
            self.assertLess(abs(force.max() - row["largest"]), 1e-3 * swing, speed)
            self.assertLess(abs(force.min() - row["least"]), 2e-3 * swing, speed)
            self.assertLess(study.unbalanced(run), 1e-11 * run["external_work"].max() + 1e-12)

    def test_a_block_that_is_pushed_stops_when_its_energy_is_spent(self):
        for row in recipe.reference("spring-block"):
            with tempfile.TemporaryDirectory() as folder:
                run = study.pushed(row["speed"], folder + "/run")
            self.assertLess(abs(run["block_ux"].max() / row["stop"] - 1), 2e-3, row["speed"])
            energy = 0.5 * rigid.MASS * row["speed"]**2
            self.assertLess(abs(run["dissipated_friction_of_Wall"][-1] / energy - 1), 2e-3, row["speed"])


if __name__ == "__main__":
    unittest.main()
