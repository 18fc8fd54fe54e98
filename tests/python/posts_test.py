#!/usr/bin/python3
"""Runs the script of docs/tutorials/posts/posts.md with few posts, and its scene of two."""
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
from support import FolderTest, ixos, main

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/tutorials/posts/posts.md"
STRENGTH = 0.0624428 * 25 / 250  # of the default law, which Gamma W divides


def block(language):
    return re.search(f"```{language}\\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)[1]


class PostsTest(FolderTest):
    def pull(self, count, scatter):
        (self.folder / "posts.py").write_text(block("python"), encoding="utf-8")
        done = subprocess.run([sys.executable, "posts.py", str(count), str(scatter)], cwd=self.folder, check=True,
                              capture_output=True, text=True, env=os.environ)
        self.assertIn("completed", done.stdout)
        return ixos.results(self.folder / f"posts-{count}-{scatter}.results")

    def test_posts_of_one_height_come_off_at_strength_times_area(self):
        table = self.pull(4, 0.0)
        self.assertLess(abs(table["reaction_top_y"].max() / (4 * 2 * STRENGTH) - 1), 0.01)
        self.assertEqual(table.summary["jumps"]["count"], 1)

    def test_scattered_posts_come_off_one_after_the_other(self):
        table = self.pull(4, 0.1)
        self.assertLess(table["reaction_top_y"].max(), 0.9 * 4 * 2 * STRENGTH)
        self.assertGreater(table.summary["jumps"]["count"], 1)
        self.assertEqual(table["contact_measure"][-1], 0)

    def test_posts_in_space_come_off_at_strength_times_area(self):
        table = self.pull("1x2", 0.0)
        self.assertLess(abs(table["reaction_top_z"].max() / (2 * 4 * STRENGTH) - 1), 0.01)

    def test_the_scene_has_bonded_parts(self):
        scene = ixos.Scene.parse("<ParameterList name=\"Posts\">" + block("xml") + "</ParameterList>")
        scene.set("Time Integrator/Time Step Control/Final Time=1", "Time Integrator/Time Step Control/Time Step=1")
        mesh = scene.mesh_arrays()
        self.assertEqual(len(mesh.points), 9 * 4 + 2 * (3 * 7) - 2 * 3)
        np.testing.assert_allclose(mesh.points.min(axis=0), [0, -6.1])


if __name__ == "__main__":
    main()
