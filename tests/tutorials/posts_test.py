#!/usr/bin/python3
"""Tests the script of docs/tutorials/posts with few posts, in the plane and in space, and its scene of two (5 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/tutorials/posts_test.py"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import tutorial

STRENGTH = 0.0624428 * 25 / 250  # of the default law, which Gamma W divides
PAGE = tutorial.path("posts", "posts.md").read_text(encoding="utf-8")


def block(language):
    return re.search(f"```{language}\\n(.*?)```", PAGE, re.DOTALL)[1]


@unittest.skipIf(importlib.util.find_spec("ixos") is None, "the Python module ixos is not there")
class Posts(unittest.TestCase):
    def pull(self, count, scatter):
        """Runs the script; returns the force that pulls, and summary.json."""
        import ixos
        with tempfile.TemporaryDirectory() as folder:
            environment = {**tutorial.recipe.ENVIRONMENT, "PYTHONPATH": os.pathsep.join(sys.path)}
            done = subprocess.run([sys.executable, "-c", block("python"), count, scatter], cwd=folder, check=False,
                                  capture_output=True, text=True, env=environment)
            self.assertIn("completed", done.stdout, done.stderr)
            table = ixos.results(pathlib.Path(folder) / f"posts-{count}-{scatter}.results")
            self.assertEqual(table["contact_measure"][-1], 0)
            return table["reaction_top_z" if "x" in count else "reaction_top_y"], table.summary

    def test_posts_of_one_height_come_off_at_strength_times_area(self):
        for count, area in (("4", 4 * 2), ("1x2", 2 * 4)):
            force, summary = self.pull(count, "0")
            self.assertLess(abs(force.max() / (area * STRENGTH) - 1), 0.01)
            self.assertEqual(summary["jumps"]["count"], 1)

    def test_scattered_posts_come_off_one_after_the_other(self):
        force, summary = self.pull("4", "0.1")
        self.assertLess(force.max(), 0.9 * 4 * 2 * STRENGTH)
        self.assertGreater(summary["jumps"]["count"], 1)

    def test_the_table_has_strength_times_area_for_posts_of_one_height(self):
        rows = re.findall(r"^\| (\S+) \| 0 \| (\S+) \| E0 L0(²?) \| 1 \| [\d.]+ s \|$", PAGE, re.MULTILINE)
        self.assertEqual([row[0] for row in rows], ["1", "16", "64", "4x4", "8x8"])
        for _, force, space in rows:
            self.assertLess(abs(float(force) / ((4 if space else 2) * STRENGTH) - 1), 0.01)

    def test_the_scene_has_bonded_parts(self):
        import ixos
        scene = ixos.Scene.parse("<ParameterList name=\"Posts\">" + block("xml") + "</ParameterList>")
        scene.set("Time Integrator/Time Step Control/Final Time=1", "Time Integrator/Time Step Control/Time Step=1")
        mesh = scene.mesh_arrays()
        self.assertEqual(len(mesh.points), 9 * 4 + 2 * (3 * 7) - 2 * 3)
        np.testing.assert_allclose(mesh.points.min(axis=0), [0, -6.1])


if __name__ == "__main__":
    unittest.main()
