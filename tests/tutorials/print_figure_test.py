#!/usr/bin/python3
"""Tests the figures of docs/tutorials/print-figure: widths, embedded fonts, pixels, and the data (8 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/tutorials/print_figure_test.py"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import tutorial
from PIL import Image

OVERVIEW, FIGURE = tutorial.ROOT / "drivers/plot/overview.py", tutorial.path("print-figure", "figure.py")
mesh = tutorial.program("bilayer-peel", "mesh")


def page_width(file):
    """Returns the width of a PDF [mm]."""
    box = re.search(rb"/MediaBox \[([^\]]*)\]", file.read_bytes()).group(1).split()
    return (float(box[2]) - float(box[0])) / 72 * 25.4


@unittest.skipUnless(mesh, "the Python module ixos is not there")
class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.place = pathlib.Path(cls.folder.name)
        mesh.film(30).write(str(cls.place / "film.e"))
        cls.result = tutorial.run("bilayer-peel", {
            "Mesh/Exodus/File": cls.place / "film.e", tutorial.STEPS + "Time Step": 2,
            tutorial.STEPS + "Final Time": 24, "Output/Fields Time Interval": 12}, cls.place / "run")

    def write(self, program, *arguments):
        subprocess.run([sys.executable, str(program), str(self.place / "run"), *arguments], cwd=self.place, check=True,
                       capture_output=True)

    def check_print(self, pdf, png, dpi):
        self.assertLess(abs(page_width(self.place / pdf) - 86), 0.5)
        self.assertIn(b"/FontFile2", (self.place / pdf).read_bytes())  # TrueType, embedded
        with Image.open(self.place / png) as image:
            self.assertLess(abs(image.size[0] - 86 / 25.4 * dpi), 3)

    def test_the_overview_has_the_width_the_fonts_and_the_data_of_the_run(self):
        self.write(OVERVIEW, "--si", "--format", "png,pdf", "--width", "86mm", "--dpi", "150", "--data", "--output",
                   "overview")
        self.check_print("overview.pdf", "overview.png", 150)
        with open(self.place / "overview-data.csv", newline="", encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(file) if (row["panel"], row["line"]) ==
                    ("pull-off force [N/m]", "line 1")]
        # In units of 1 ms and 1 N/m the numbers of the scene are those of the axes.
        time = (self.result["time"] - self.result["time_step"] / 2)[1:]
        np.testing.assert_allclose([float(row["x"]) for row in rows], time, rtol=1e-12)
        np.testing.assert_allclose([float(row["y"]) for row in rows], self.result["reaction_end_y"][1:], rtol=1e-12,
                                   atol=1e-15)

    def test_the_figure_of_fifteen_lines_has_the_width_and_the_fonts(self):
        self.write(FIGURE)
        self.check_print("figure.pdf", "figure.png", 300)

    def test_the_page_shows_the_program_that_it_runs(self):
        page = tutorial.path("print-figure", "print-figure.md").read_text(encoding="utf-8")
        program = FIGURE.read_text(encoding="utf-8").split("\n", 1)[1]
        self.assertIn("```python\n" + program + "```", page)


if __name__ == "__main__":
    unittest.main()
