#!/usr/bin/python3
"""Follows docs/meshes.md: IXOS_DRIVER=.../ixos tests/guide/meshes_test.py

Its blocks are those of the files in meshes/, its scene runs on one and two ranks with the result that it states, and the
sets that it selects by place are those of the groups.
"""
import csv
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MESHES = ROOT / "meshes"
DRIVER = os.environ.get("IXOS_DRIVER", "ixos")
PAGE = (ROOT / "docs/meshes.md").read_text(encoding="utf-8")
SCENE = (MESHES / "pillar.xml").read_text(encoding="utf-8")


def blocks(language):
    """Returns the page's blocks of code in a language."""
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


def squeeze(text):
    """Returns the text without white space."""
    return re.sub(r"\s+", "", text)


class MeshesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.keep.name)
        (cls.folder / "pillar.msh").write_bytes((MESHES / "pillar.msh").read_bytes())

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def run_scene(self, name, scene, ranks=1):
        """Runs a scene beside the mesh; returns its summary and the reactions of the head."""
        path, results = self.folder / (name + ".xml"), self.folder / name
        path.write_text(scene, encoding="utf-8")
        launcher = [] if ranks == 1 else ["mpiexec", "-np", str(ranks)]
        done = subprocess.run([*launcher, DRIVER, path, "--quiet", "--output", results], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(results / "history.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        column = next(name for name in rows[0] if re.fullmatch("reaction_.*_y", name))
        return json.loads((results / "summary.json").read_text()), [float(row[column]) for row in rows if row[column]]

    def test_the_blocks_are_those_of_the_files(self):
        self.assertEqual(blocks("geo"), [(MESHES / "pillar.geo").read_text(encoding="utf-8")])
        self.assertIn(squeeze(blocks("xml")[0]), squeeze(SCENE))

    def test_the_run_ends_as_the_page_says_on_any_ranks(self):
        summary, one = self.run_scene("one", SCENE)
        self.assertEqual(summary["status"], "stopped")
        self.assertEqual(summary["elements"], 288)
        self.assertAlmostEqual(summary["end_time"], 29.05, delta=0.15)
        self.assertAlmostEqual(max(one), 1.13, delta=0.005)
        _, two = self.run_scene("two", SCENE, ranks=2)
        peak = one.index(max(one))  # the motion after the foot has snapped off is chaotic
        for a, b in zip(one[:peak], two[:peak]):
            self.assertAlmostEqual(a, b, delta=1e-8)

    def test_sets_by_place_are_those_of_the_groups(self):
        sets = next(block for block in blocks("xml") if block.lstrip().startswith('<ParameterList name="Sets">'))
        scene = SCENE.replace("<ParameterList name=\"Mesh\">", "<ParameterList name=\"Mesh\">" + sets)
        scene = scene.replace('value="foot"', 'value="underside"').replace('value="head"', 'value="upper end"')
        scene = scene.replace('value="{head}"', 'value="{upper end}"')
        _, by_group = self.run_scene("group", SCENE)
        _, by_place = self.run_scene("place", scene)
        peak = by_group.index(max(by_group))
        self.assertGreater(peak, 200)
        for a, b in zip(by_group[:peak], by_place[:peak]):
            self.assertAlmostEqual(a, b, delta=1e-8)

    def test_the_check_prints_the_quality(self):
        done = subprocess.run([DRIVER, MESHES / "pillar.xml", "--check"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("288 cells, 331 nodes", done.stdout)


if __name__ == "__main__":
    unittest.main()
