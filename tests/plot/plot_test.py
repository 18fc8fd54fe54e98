#!/usr/bin/python3
"""Tests of drivers/plot on a short run of the ball: IXOS_DRIVER=.../ixos IXOS_XML=.../xml tests/plot/plot_test.py"""
import os
import shutil
import subprocess
import sys
import unittest

import numpy as np
from PIL import Image

sys.dont_write_bytecode = True
from scripts import PLOT, ScriptTest, simulate  # noqa: E402 (sets the path to the others)
import result_files  # noqa: E402
from exodus import Fields  # noqa: E402
from results import Run  # noqa: E402

SHORT = ["Time Integrator/Time Step Control/Final Time=0.05", "Output/Fields Interval=10"]
CUBE = ["Mesh/Type=Box", "Mesh/Box/Dimension=3", "Mesh/Box/Lower={-1,-1,1}", "Mesh/Box/Lengths={2,2,2}",
        "Mesh/Box/Divisions={2,2,2}", "Interactions/Wall/Side Set=bottom",
        "Time Integrator/Time Step Control/Final Time=0.003", "Output/Fields Interval=1"]


# Hexahedra, pyramids and tetrahedra of second order, 1 above the wall.
MIXED = ["Mesh/Type=Gmsh", f"Mesh/Gmsh/File={PLOT.parents[1] / 'tests' / 'io' / 'gmsh' / 'mixed-2.msh'}", "Mesh/Map/Z=z+1",
         *CUBE[5:]]


class PlotTest(ScriptTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.ball = cls.folder / "ball"
        simulate(cls.ball, SHORT)

    def test_fields_agree_with_the_history(self):
        fields, run = Fields(self.ball), Run(self.ball)
        self.assertEqual(fields.dimension, 2)
        self.assertEqual(len(fields.cells), 48)
        self.assertEqual(fields.coordinates.shape, (57, 2))
        np.testing.assert_allclose(fields.times, run["time"][::10], rtol=0, atol=1e-12)
        self.assertEqual(np.abs(fields.displacement(0)).max(), 0.0)
        self.assertGreater(np.abs(fields.displacement(5)).max(), 1e-3)
        for frame in range(len(fields.times)):
            for name in ("kinetic_energy", "elastic_energy", "contact_energy", "total_energy"):
                self.assertAlmostEqual(fields.total(name, frame), run[name][10 * frame], delta=1e-12)
        np.testing.assert_allclose(fields.element("first_stress_invariant", 0), 0.0, atol=1e-14)
        np.testing.assert_allclose(fields.element("jacobian", 0), 1.0, atol=1e-14)

    def test_the_files_of_two_ranks_hold_the_fields_of_one(self):
        two = self.folder / "two"
        simulate(two, SHORT, ranks=2)
        self.assertEqual(sorted(path.name for path in two.glob("fields.e*")), ["fields.e.2.0", "fields.e.2.1"])
        one, both = Fields(self.ball), Fields(two)
        np.testing.assert_allclose(both.coordinates, one.coordinates, atol=1e-12)
        np.testing.assert_array_equal(both.cells, one.cells)
        for frame in range(len(one.times)):
            np.testing.assert_allclose(both.displacement(frame), one.displacement(frame), atol=1e-11)
            for field in ("first_stress_invariant", "energy_density"):
                np.testing.assert_allclose(both.element(field, frame), one.element(field, frame), atol=1e-11)

    def test_the_one_hdf5_file_of_any_ranks_holds_the_same_fields(self):
        one = Fields(self.ball)
        for ranks in (1, 2, 4):
            folder = self.folder / f"hdf5-{ranks}"
            simulate(folder, [*SHORT, "Output/Fields Format=HDF5"], ranks)
            self.assertEqual([path.name for path in folder.glob("fields*")], ["fields.e"])
            self.assertEqual((folder / "fields.e").read_bytes()[:4], b"\x89HDF")
            all_ranks = Fields(folder)
            np.testing.assert_array_equal(all_ranks.times, one.times)
            np.testing.assert_array_equal(all_ranks.coordinates, one.coordinates)
            np.testing.assert_array_equal(all_ranks.cells, one.cells)
            for frame in range(len(one.times)):
                for field, tolerance in (("displacement", 1e-11), ("velocity", 1e-9), ("acceleration", 1e-6),
                                         ("interaction_traction", 1e-11)):
                    np.testing.assert_allclose(all_ranks.nodal(field, frame), one.nodal(field, frame), atol=tolerance)
                for field in ("first_stress_invariant", "jacobian", "energy_density"):
                    np.testing.assert_allclose(all_ranks.element(field, frame), one.element(field, frame), atol=1e-11)
                self.assertAlmostEqual(all_ranks.total("total_energy", frame), one.total("total_energy", frame), delta=1e-12)

    def test_enriched_cells_read_back(self):
        # 40 of 80 x 2 cells have the contact side; of a row, the last carries the field of its cell.
        coarse = ["Mesh/Box/Divisions={80, 2}", "Mesh/Sets/contact/Upper={100, 1}", "Output/Fields Time Interval=2",
                  "Time Integrator/Type=Static", "Time Integrator/Time Step Control/Time Step=1",
                  "Histories/Pull/Rate Ramp/Length=4", "Time Integrator/Time Step Control/Final Time=4"]
        for element, parts in (("Q1C4", 4), ("Q1CH", 4), ("Q1C2", 2)):
            shown = []
            for ranks in (1, 2):
                folder = self.folder / f"strip-{element}-{ranks}"
                simulate(folder, [*coarse, f"Interactions/Wall/Contact Element={element}"], ranks, "strip.xml")
                shown.append(Fields(folder))
                self.assertEqual(len(shown[-1].cells), 160 + 40 * (parts - 1))
            one, two = shown
            corners = one.coordinates[one.cells]
            x, y = corners[..., 0], corners[..., 1]
            areas = 0.5 * np.sum(x * np.roll(y, -1, 1) - y * np.roll(x, -1, 1), axis=1)
            self.assertAlmostEqual(areas.sum(), 2000.0, delta=1e-3)
            self.assertGreater(areas.min(), 0.0)
            # Both hold the same motion, whatever the order of their nodes.
            for frame in range(len(one.times)):
                ends = [np.sort(np.round(f.displacement(frame)[:, 1], 9)) for f in (one, two)]
                np.testing.assert_allclose(ends[0].max(), ends[1].max(), atol=1e-9)
                np.testing.assert_allclose(ends[0].min(), ends[1].min(), atol=1e-8)

    def test_cells_of_several_shapes(self):
        simulate(self.folder / "mixed", MIXED)
        fields = result_files.Fields(self.folder / "mixed")
        counts = np.count_nonzero(fields.cells >= 0, axis=1)
        self.assertEqual(sorted(set(counts)), [10, 14, 27])
        self.assertEqual(fields.cells.shape[1], 27)
        own = {name: len(cells) for name, cells in fields.blocks.items()}
        self.assertEqual(own, {"body": 1, "body_2": 24, "body_3": 1})
        bottom = fields.points[fields.side_set_nodes["bottom"]]
        np.testing.assert_allclose(bottom[:, 2], 1, atol=1e-12)
        self.assertEqual(bottom[:, 0].max(), 2)
        simulate(self.folder / "triangles", ["Mesh/Map/Z=", "Mesh/Type=Gmsh",
                                             f"Mesh/Gmsh/File={str(PLOT.parents[1])}/tests/io/gmsh/triangles.msh",
                                             "Mesh/Cell Order=2", "Mesh/Sets/bottom/Normal={0,-1}", "Mesh/Map/Y=y+1",
                                             *CUBE[5:]])
        fields = Fields(self.folder / "triangles")
        outlines = fields.polygons(0)
        self.assertEqual({len(outline) for outline in outlines}, {6})
        area = sum(0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) for x, y in (o.T for o in outlines))
        self.assertAlmostEqual(area, 1, delta=1e-12)

    @unittest.skipUnless(os.environ.get("DISPLAY") or shutil.which("xvfb-run"), "neither a display nor xvfb-run")
    def test_a_picture_of_cells_of_several_shapes(self):
        simulate(self.folder / "drawn", MIXED)
        png, = self.draw("fields.py", self.folder / "drawn", "--frames", 2)
        self.assert_picture(png, "PNG", 1000, 1600)

    def test_energy_density_sums_to_the_elastic_energy(self):
        fields, run = Fields(self.ball), Run(self.ball)
        frame = len(fields.times) - 1
        corners = [fields.coordinates[cell] for cell in fields.cells]
        areas = [0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) for x, y in (c.T for c in corners)]
        total = float(np.dot(areas, fields.element("energy_density", frame)))
        self.assertAlmostEqual(total / run["elastic_energy"][-1], 1.0, delta=1e-13)

    def test_history(self):
        png, svg = self.draw("history.py", self.ball, "--format", "png,svg")
        self.assertEqual((png, svg), (self.ball / "history.png", self.ball / "history.svg"))
        self.assert_picture(png, "PNG", 1300, 1500)
        text = svg.read_text()
        self.assertIn("<svg", text)
        for label in ("kinetic", "energy error", "least gap", "contact force y", "iterations", "time [T₀]"):
            self.assertIn(label, text)

    def test_histories_compared(self):
        other = self.folder / "other"
        simulate(other, SHORT[:1] + ["Time Integrator/Type=Gautam-Sauer Composite", "Output/Interaction=false"])
        svg, = self.draw("history.py", self.ball, other, "--relative", "initial", "--output", self.folder / "two.svg")
        for label in ("Gautam-Sauer Composite", "Average Vector Field", "/ |initial energy|"):
            self.assertIn(label, svg.read_text())
        alone, = self.draw("history.py", other, "--format", "svg", "--time", "0.01,0.03")
        self.assertNotIn("least gap", alone.read_text())

    def test_reactions_of_step_means_stand_at_the_middle(self):
        folder = self.folder / "reactions"
        folder.mkdir()
        (folder / "history.csv").write_text("step,time,time_step,linear_momentum_x,total_energy,reaction_top_y\n"
                                            "0,0,0,0,1,\n1,0.5,0.5,0,1,3\n2,1,0.5,0,1,4\n")
        for scheme, times in (("Average Vector Field", [0.25, 0.75]), ("Newmark", [0.0, 0.5, 1.0])):
            (folder / "summary.json").write_text('{"scheme": "%s"}' % scheme)
            (name, time, values), = Run(folder).reactions()
            self.assertEqual((name, list(time), list(values[-2:])), ("reaction_top_y", times, [3.0, 4.0]))

    def test_fields(self):
        png, svg = self.draw("fields.py", self.ball, "--times", "0,0.03,0.05", "--format", "png,svg")
        self.assert_picture(png, "PNG", 1000, 1600)
        self.assertIn("t = 0.03 T₀", svg.read_text())
        png, = self.draw("fields.py", self.ball, "--frames", 2, "--field", "jacobian", "--range", "0.9,1.1",
                         "--no-wall", "--output", self.folder / "jacobian")
        self.assert_picture(png, "PNG", 800, 1600)
        svg, = self.draw("fields.py", self.ball, "--times", "0.05", "--field", "velocityX", "--format", "svg", "--output",
                         self.folder / "velocity")
        self.assertIn("velocityX [L₀/T₀]", svg.read_text())

    def plate(self, *options):
        """The share of a picture that has the colour of an oblique wall before white."""
        png, = self.draw("fields.py", self.folder / "slope", "--frames", 1, *options)
        with Image.open(png) as image:
            pixels = np.asarray(image.convert("RGB")).astype(int)
        return (np.abs(pixels - round(255 * (0.4 * 0.72 + 0.6))) <= 2).all(axis=-1).mean()

    @unittest.skipUnless(os.environ.get("DISPLAY") or shutil.which("xvfb-run"), "neither a display nor xvfb-run")
    def test_fields_in_space(self):
        simulate(self.folder / "cube", CUBE)
        png, = self.draw("fields.py", self.folder / "cube", "--frames", 2)
        self.assert_picture(png, "PNG", 1000, 1600)
        png, = self.draw("fields.py", self.folder / "cube", "--frames", 2, "--view=0.2,-1,0.2", "--range=-0.1,0.2",
                         "--output", self.folder / "other")
        self.assert_picture(png, "PNG", 1000, 1600)
        self.assert_refused("not a direction", "fields.py", self.folder / "cube", "--view=0,0,1")
        simulate(self.folder / "slope", [*CUBE, "Interactions/Wall/Normal={1, 0, 1}", "Interactions/Wall/Point={0, 0, -1}"])
        self.assertGreater(self.plate(), 0.05)
        self.assertLess(self.plate("--no-wall"), 0.01)
        self.assert_refused("not plane", "animate.py", self.folder / "cube")

    @unittest.skipUnless(os.environ.get("DISPLAY") or shutil.which("xvfb-run"), "neither a display nor xvfb-run")
    def test_a_fine_mesh_shows_its_edges_only(self):
        simulate(self.folder / "fine", [*CUBE, "Mesh/Box/Divisions={18,18,18}",
                                        "Time Integrator/Time Step Control/Final Time=0.001"])
        png, = self.draw("fields.py", self.folder / "fine", "--frames", 1, "--no-wall", "--range=-9,9")
        with Image.open(png) as image:
            dark = np.asarray(image.convert("L"))[:, :image.width * 3 // 4] < 128
        self.assertTrue(0.001 < dark.mean() < 0.1, dark.mean())

    def test_space_without_display(self):
        simulate(self.folder / "cube2", CUBE)
        done = subprocess.run(["/usr/bin/python3", "-B", PLOT / "fields.py", self.folder / "cube2"], check=False,
                              text=True, capture_output=True, env={"PATH": "", "HOME": os.environ.get("HOME", "/")})
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
        self.assertIn("xvfb", done.stderr)

    @unittest.skipUnless(shutil.which("ffprobe"), "no ffmpeg")
    def test_a_movie(self):
        movie, = self.draw("animate.py", self.ball, "--output", self.folder / "ball.mp4")
        asked = ["ffprobe", "-v", "error", "-show_entries", "stream=codec_name,width,height,nb_frames", "-of", "csv=p=0"]
        told = subprocess.run([*asked, movie], capture_output=True, text=True, check=True).stdout.split()
        self.assertEqual(told, [f"h264,640,400,{len(Fields(self.ball).times)}"])

    def test_animation(self):
        self.assert_refused("ends in .gif or .mp4", "animate.py", self.ball, "--output", "ball.avi")
        gif, = self.draw("animate.py", self.ball, "--every", 2, "--fps", 10)
        with Image.open(gif) as image:
            self.assertEqual((image.format, image.size, image.n_frames), ("GIF", (640, 400), 3))
            self.assertEqual(image.info["duration"], 100)
            for frame in range(3):
                image.seek(frame)
                self.assertEqual(image.convert("RGB").getpixel((2, 2)), (255, 255, 255))
        self.assertLess(gif.stat().st_size, 200000)

    def test_what_is_missing_is_named_on_one_line(self):
        bare = self.folder / "bare"
        bare.mkdir(exist_ok=True)
        for name in ("history.py", "fields.py", "animate.py"):
            self.assert_refused("does not exist", name, self.folder / "none")
            self.assert_refused("does not exist", name, bare)
            self.assert_refused("unrecognized", name, self.ball, "--wrong")
        self.assert_refused("no frame near time 7", "fields.py", self.ball, "--times", "0,7")
        self.assert_refused("no field 'stress'; it has", "fields.py", self.ball, "--field", "stress")
        self.assert_refused("not an interval", "fields.py", self.ball, "--range", "2,1")
        self.assert_refused("unknown format", "history.py", self.ball, "--format", "gif")
        self.assert_refused("neither initial nor", "history.py", self.ball, "--relative", "zero")
        self.assert_refused("no rows from time 3", "history.py", self.ball, "--time", "3,4")
        self.assert_refused("fewer than two frames", "animate.py", self.ball, "--every", "100")
        self.assert_refused("cannot be written", "history.py", self.ball, "--output", bare / "no" / "such")
        self.assert_refused("cannot be written", "animate.py", self.ball, "--output", bare / "no" / "such.gif")

    def test_damaged_files(self):
        folder = self.folder / "damaged"
        shutil.copytree(self.ball, folder, dirs_exist_ok=True)
        lines = (folder / "history.csv").read_text().splitlines()
        (folder / "history.csv").write_text("\n".join(lines[:-1] + [lines[-1][:20]]))
        self.assertEqual(len(Run(folder)["time"]), len(lines) - 2)
        (folder / "history.csv").write_text("\n".join(line.rsplit(",", 4)[0] for line in lines))
        self.assert_refused("no column 'min_gap'", "history.py", folder)
        (folder / "fields.e").write_text("nonsense")
        self.assert_refused("not an Exodus file", "fields.py", folder)
        (folder / "fields.e").rename(folder / "fields.e.2.0")
        self.assert_refused("has 1 files, not 2", "fields.py", folder)


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(1 if not outcome.wasSuccessful() else 77 if outcome.skipped else 0)  # 77: some were skipped
