#!/usr/bin/python3
"""Tests of overview.py (ixos-plot), and of cells in pieces, on short runs: IXOS_DRIVER=.../ixos IXOS_XML=.../xml
tests/plot/overview_test.py"""
import csv
import os
import shutil
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np
from PIL import Image

sys.dont_write_bytecode = True
from scripts import PLOT, ScriptTest, script  # noqa: E402 (sets the path to the others)
from plot_test import CUBE, SHORT, simulate  # noqa: E402
from synthetic import peel  # noqa: E402

import style  # noqa: E402
from exodus import Fields  # noqa: E402
from results import Run  # noqa: E402

STEPS = "Time Integrator/Time Step Control/"
STRIP = ["Mesh/Box/Divisions={20, 2}", STEPS + "Time Step=1", STEPS + "Final Time=6", "Histories/Pull/Rate Ramp/Length=5",
         "Output/Fields Time Interval=1"]


def area(polygon):
    x, y = polygon.T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


class OverviewTest(ScriptTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.ball, cls.strip = cls.folder / "ball", cls.folder / "strip"
        simulate(cls.ball, SHORT)
        simulate(cls.strip, STRIP, scene="strip.xml")

    def test_a_free_body_shows_its_energies(self):
        png, svg = self.draw("overview.py", self.ball, "--format", "png,svg")
        self.assertEqual(png, self.ball / "overview.png")
        self.assert_picture(png, "PNG", 1300, 1700)
        for words in ("Average Vector Field", "first stress invariant", "kinetic", "energy", "least gap", "time [T₀]",
                      "t = 0.05 T₀"):
            self.assertIn(words, svg.read_text())

    def test_a_pulled_body_shows_the_force(self):
        svg, = self.draw("overview.py", self.strip, "--si", "--output", self.folder / "strip.svg")
        for words in ("pull-off force", "[N/m]", "least gap", "[nm]", "time [ns]", "x [nm]", "t = 6 ns"):
            self.assertIn(words, svg.read_text())
        self.assertNotIn("kinetic", svg.read_text())

    def test_a_failed_run_shows_its_whole_reason(self):
        import overview
        run = Run(self.strip)
        reason = " ".join(f"word{number}" for number in range(60))
        run.summary.update(status="diverged", reason=reason)
        lines = overview.headline(run).splitlines()
        self.assertTrue(" ".join(lines).endswith("diverged: " + reason))
        self.assertLessEqual(max(map(len, lines)), 110)
        with unittest.mock.patch.object(style, "output", style.output._replace(width=86 / 25.4)):
            lines = overview.headline(run).splitlines()
        self.assertTrue(" ".join(lines).endswith("diverged: " + reason))
        self.assertLessEqual(max(map(len, lines)), 50)

    def test_frames_are_those_around_the_largest_force(self):
        import overview
        import pull
        run, fields = Run(self.strip), Fields(self.strip)  # frames from 0 to 6
        for peak, count, frames in ((2.6, 4, [0, 2, 3, 6]), (3, 4, [0, 3, 4, 6]), (6, 4, [0, 2, 4, 6]), (2.6, 2, [2, 6])):
            with unittest.mock.patch.object(pull, "force", lambda _, at=peak: ("", np.array([0, at]), np.array([1, 9]))):
                self.assertEqual(overview.frames_that_matter(run, fields, count), frames)

    def test_curves_along_a_surface_are_those_of_the_force(self):
        folder = self.folder / "along"
        simulate(folder, STRIP + ["Output/Fields={displacement, gap, contact_pressure, interaction_traction}",
                                  "Interactions/Wall/Contact Element=Q1C1"],
                 scene="strip.xml")
        png, data = self.draw("overview.py", folder, "--along", "contact", "--times", "3,6", "--data")
        self.assertEqual(png, folder / "along-contact.png")
        with open(data, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        run = Run(folder)

        def curve(panel, time):
            return np.array([(float(row["x"]), float(row["y"])) for row in rows
                             if row["panel"].startswith(panel) and row["line"].startswith(f"t = {time} ")]).T

        for time in (3, 6):
            at = int(np.argmin(np.abs(run["time"] - time)))
            x, gap = curve("gap", time)
            self.assertTrue((np.diff(x) > 0).all())
            self.assertAlmostEqual(gap.min() / run["min_gap"][at], 1, 2)  # between nodes it may be less
            # The force on the body is the integral of the traction along the surface, up to the rule of trapezia.
            place, traction = curve("interaction traction y", time)
            force = np.sum(np.diff(place) * (traction[1:] + traction[:-1]) / 2)
            size = np.sum(np.diff(place) * (abs(traction[1:]) + abs(traction[:-1])) / 2)
            self.assertLess(abs(force - run["contact_force_y"][at]), 0.01 * size)
        for words, arguments in (("has no set 'botom'; it has bottom, ", ["--along", "botom"]),
                                 ("has no field 'gapp'; it has contact_pressure, ", ["--along", "bottom", "--field", "gapp"]),
                                 ("belong to --along", ["--field", "gap"])):
            done = script("overview.py", folder, *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
        done = script("overview.py", self.strip, "--along", "bottom", "--field", "jacobian")
        self.assertIn("'jacobian' is a field of cells; fields of nodes: displacement, ", done.stderr)

    def test_a_line_of_nodes_in_space_has_curves(self):
        folder = self.folder / "line"
        simulate(folder, CUBE + ["Mesh/Sets/Middle/Kind=Nodes", "Mesh/Sets/Middle/Lower={-1, 0, 1}",
                                 "Mesh/Sets/Middle/Upper={1, 0, 1}", "Output/Fields={displacement, gap}"])
        _, data = self.draw("overview.py", folder, "--along", "Middle", "--times", "0", "--data")
        with open(data, encoding="utf-8") as file:
            rows = [(float(row["x"]), float(row["y"])) for row in csv.DictReader(file)
                    if row["panel"].startswith("gap")]
        np.testing.assert_allclose(rows, [(-1, 1), (0, 1), (1, 1)], atol=1e-9)
        done = script("overview.py", folder, "--along", "bottom")
        self.assertIn("the set 'bottom' is no line of nodes, since some are beside each other", done.stderr)

    def test_the_arrow_is_the_reaction(self):
        import overview
        run, fields = Run(self.strip), Fields(self.strip)
        places, forces = overview.reaction_vectors(run, fields, [0, 3, 6])
        # The right edge, 200 L0 from the left one and held there along x, is where the probe says.
        np.testing.assert_allclose(places[:, 0], 200, atol=1e-5)
        np.testing.assert_allclose(places[2, 1] - places[0, 1], run["edge_uy"][-1], atol=1e-5)
        _, times, values = run.reaction("right_y")
        np.testing.assert_allclose(forces[1, 1], np.interp(3, times, values), rtol=1e-12)
        arrows = overview.arrows_of((places, forces), ((0, 300), (0, 400)))
        self.assertIsNone(arrows[0])
        self.assertAlmostEqual(np.hypot(*(arrows[2][1] - arrows[2][0])), 500 / 6)

    def test_the_moment_of_the_largest_force_is_among_the_configurations(self):
        import overview
        run, fields = Run(self.strip), Fields(self.strip)
        kept, run.reaction = run.reaction, None
        for peak in range(len(fields.times)):
            force = np.where(np.arange(len(run["time"])) == np.argmin(np.abs(run["time"] - fields.times[peak])), 1.0, 0.0)
            run.reaction = lambda name, force=force: (name or "reaction_right_y", run["time"], force)
            for count in (2, 4):
                frames = overview.frames_that_matter(run, fields, count)
                self.assertIn(peak, frames)
                self.assertEqual((len(frames), frames[-1]), (count, len(fields.times) - 1))
        run.reaction = kept

    def test_the_arrow_of_a_body_of_revolution_is_along_its_axis(self):
        import overview
        run, fields = Run(self.strip), Fields(self.strip)
        run.body_dimension = 3
        _, forces = overview.reaction_vectors(run, fields, [0, 3])
        np.testing.assert_array_equal(forces[:, 0], 0)
        self.assertNotEqual(forces[1, 1], 0)

    def test_a_figure_for_print_has_its_width_its_fonts_and_its_data(self):
        name = self.folder / "print"
        png, pdf, eps, table = self.draw("overview.py", self.strip, "--width", "174mm", "--dpi", "300", "--pdf", "--eps",
                                         "--format", "png", "--data", "--output", name)
        self.assert_picture(png, "PNG", *(round(174 / 25.4 * 300) + change for change in (-2, 2)))
        self.assertIn(b"/FontFile2", pdf.read_bytes())
        self.assertIn(b"/FontType 42", eps.read_bytes())
        self.assertEqual(table, self.folder / "print-data.csv")
        rows = [line.split(",") for line in table.read_text().splitlines()]
        self.assertEqual(rows[0], ["panel", "line", "x", "y", "value"])
        fields = Fields(self.strip)
        cells = [row for row in rows if row[1] == "cells" and row[0] == f"t = {fields.times[0]:.4g} T₀"]
        stress = fields.of_wholes(fields.element("first_stress_invariant", 0))
        self.assertEqual([float(row[4]) for row in cells], list(stress))
        self.assertEqual([float(row[2]) for row in cells], [polygon[:, 0].mean() for polygon in fields.polygons(0)])
        times = [float(row[2]) for row in rows if row[0].startswith("least gap")]
        self.assertEqual((times[0], times[-1]), (0, 6))

    def test_the_data_of_a_picture_leave_the_runs_history_alone(self):
        before = (self.strip / "history.csv").read_bytes()
        self.assertIn(self.strip / "history-data.csv", self.draw("history.py", self.strip, "--data"))
        self.assertEqual((self.strip / "history.csv").read_bytes(), before)

    def test_widths_without_room_are_refused(self):
        self.assert_refused("is not a width", "overview.py", self.strip, "--width", "86")
        self.assert_refused("choose at least", "history.py", self.strip, "--width", "20mm")
        self.assert_refused("unknown format 'jpg'; allowed: png, svg, pdf, eps", "overview.py", self.strip, "--format",
                            "jpg")

    def test_without_fields_the_curves_remain(self):
        done = script("overview.py", peel(self.folder / "bare"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no configurations: the file", done.stderr)
        self.assertEqual(done.stdout, f"{self.folder / 'bare' / 'overview.png'}\n")

    @unittest.skipUnless(os.environ.get("DISPLAY") or shutil.which("xvfb-run"), "neither a display nor xvfb-run")
    def test_a_body_in_space(self):
        simulate(self.folder / "cube", CUBE)
        png, = self.draw("overview.py", self.folder / "cube")
        self.assert_picture(png, "PNG", 1300, 1700)

    def test_without_a_display_the_curves_remain(self):
        simulate(self.folder / "blind", CUBE)
        done = subprocess.run(["/usr/bin/python3", "-B", PLOT / "overview.py", self.folder / "blind"], check=False,
                              text=True, capture_output=True, env={"PATH": "", "HOME": os.environ.get("HOME", "/")})
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (0, 1), done.stderr)
        self.assertIn("no configurations: VTK cannot render", done.stderr)

    def test_pieces_of_enriched_cells_are_one_outline(self):
        for ranks in (1, 2):
            folder = self.folder / f"enriched{ranks}"
            simulate(folder, [*SHORT, "Interactions/Wall/Contact Element=Q1C4"], ranks)
            fields = Fields(folder)
            self.assertEqual((len(fields.cells), len(fields.wholes)), (32 + 16 * 4, 48))
            self.assertEqual(sorted(i for whole in fields.wholes for i in whole), list(range(96)))
            frame = len(fields.times) - 1
            positions = fields.coordinates + fields.displacement(frame)
            stress = fields.element("first_stress_invariant", frame)
            for whole, outline in zip(fields.wholes, fields.polygons(frame)):
                self.assertEqual(len(outline), 4 if len(whole) == 1 else 10)
                pieces = sum(area(positions[fields.cells[i]]) for i in whole)
                self.assertAlmostEqual(area(outline) / pieces, 1, delta=1e-12)
                self.assertEqual(np.ptp(stress[whole]), 0)
            np.testing.assert_array_equal(fields.of_wholes(stress), [stress[whole[-1]] for whole in fields.wholes])

    def test_rounding_errors_are_not_painted(self):
        noise = 1e-13 * np.linspace(-1, 1, 9)
        self.assertTrue(style.is_noise("first_stress_invariant", noise))
        self.assertTrue(style.is_noise("jacobian", 1 + noise))
        self.assertTrue(style.is_noise("energy_density", 2 + noise))
        self.assertFalse(style.is_noise("first_stress_invariant", 1e6 * noise))
        self.assertFalse(style.is_noise("energy_density", noise + 1e-13))
        for field, values in (("first_stress_invariant", noise), ("jacobian", 1 + noise)):
            _, norm = style.color_scale(field, values)
            self.assertLess(np.ptp(norm(values)), 1e-3, field)
        png, = self.draw("fields.py", self.ball, "--times", "0", "--output", self.folder / "still")
        with Image.open(png) as image:
            colors = np.asarray(image.convert("RGB")).astype(int)
        body = colors[:, :image.width // 2]
        self.assertLess((np.ptp(body, axis=2) > 8).mean(), 0.001, "colours in the body at rest")


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(1 if not outcome.wasSuccessful() else 77 if outcome.skipped else 0)  # 77: some were skipped
