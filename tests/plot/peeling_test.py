#!/usr/bin/python3
"""Tests of the pictures and numbers of peeling runs, on folders made from formulas: tests/plot/peeling_test.py"""
import argparse
import json
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True
from scripts import ScriptTest, script  # noqa: E402 (sets the path to the others)
import cost  # noqa: E402
import measures  # noqa: E402
import options  # noqa: E402
import peeling  # noqa: E402
import style  # noqa: E402
from results import ResultsError, Run, common, labels  # noqa: E402
from synthetic import END, START, contact, force, peel, write_history  # noqa: E402

PERIOD = 0.25


def sine(time):
    """A sine of the amplitude 0.01."""
    return 0.01 * np.sin(2 * np.pi * time / PERIOD)


class MeasuresTest(unittest.TestCase):
    def test_a_sine_oscillates_by_its_amplitude_over_root_two(self):
        time = np.arange(4001) * 0.005
        absolute, relative = measures.oscillation(time, 2 + sine(time), (5, 15), 4)
        self.assertAlmostEqual(absolute / (0.01 / 2 ** 0.5), 1, delta=0.03)
        self.assertAlmostEqual(relative, absolute / 2, delta=1e-6)
        # A trend that a parabola follows adds nothing; neither do rows of uneven spacing.
        trend = 1 - 0.3 * time + 0.02 * time ** 2
        self.assertAlmostEqual(measures.oscillation(time, trend + sine(time), (5, 15), 4)[0], absolute, delta=1e-9)
        uneven = np.sort(np.concatenate([time, time[1500:2500] + 0.0021]))
        self.assertAlmostEqual(measures.oscillation(uneven, sine(uneven), (5, 15), 4)[0] / absolute, 1, delta=0.02)

    def test_the_bounds_that_the_description_of_oscillation_gives(self):
        time = np.arange(6001) * 0.01
        for ratio in np.arange(5, 12, 0.37):
            wave = np.sin(2 * np.pi * ratio / 3 * time)
            end = 20 + round(20 * ratio / 3) * 3 / ratio
            self.assertAlmostEqual(measures.oscillation(time, wave, (20, end), 3)[0] * 2 ** 0.5, 1, delta=0.1)
        self.assertLess(measures.oscillation(time, np.sin(2 * np.pi * 0.5 / 3 * time), (18, 42), 3)[0] * 2 ** 0.5, 0.03)
        self.assertLess(measures.oscillation(time, 3 - time + time ** 2, (0, 60), 3)[0], 1e-9)

    def test_no_oscillation_where_it_cannot_be_seen(self):
        time = np.arange(201) * 0.1
        for interval, window in (((5, 15), 0.3), ((5, 25), 2), ((-5, 15), 2), ((5.01, 5.09), 2)):
            self.assertTrue(np.isnan(measures.oscillation(time, sine(time), interval, window)).all(), interval)
        self.assertTrue(np.isfinite(measures.oscillation(time, sine(time) + 1, (0, 20), 0.9)).all())
        self.assertTrue(np.isnan(measures.oscillation(time, 0 * time, (5, 15), 2)[1]))

    def test_detachment_is_for_good(self):
        time = np.arange(8) * 0.5
        for values, expected in (([9, 5, 0, 0, 2, 0, 0, 0], 2.5), ([9, 5, 4, 3, 2, 1, 1, 0], 3.5),
                                 ([9, 5, 0, 0, 0, 0, 0, 1], np.nan), ([0] * 8, np.nan), ([np.nan] * 8, np.nan),
                                 ([9, 5, 0, 0, 0, 0, np.nan, np.nan], np.nan)):
            np.testing.assert_equal(measures.detachment(time, np.array(values, dtype=float)), expected)

    def test_deviation_from_a_reference(self):
        coarse, fine = np.arange(11) * 1.0, np.arange(1001) * 0.01
        self.assertAlmostEqual(measures.deviation(coarse + 0.5, 3 * (coarse + 0.5), fine, 3 * fine)[0], 0, delta=1e-12)
        absolute, relative = measures.deviation(coarse, 0 * coarse + 2.5, fine, 0 * fine + 2)
        self.assertAlmostEqual(absolute, 0.5, delta=1e-12)
        self.assertAlmostEqual(relative, 0.25, delta=1e-12)
        off = 2 + (coarse > 4.5)
        self.assertAlmostEqual(measures.deviation(coarse, off, fine, 0 * fine + 2, (5, 9))[0], 1, delta=1e-12)
        self.assertEqual(measures.deviation(coarse, off, fine, 0 * fine + 2, (0, 4))[0], 0)
        # Nothing is said of a run that ended before the interval did, whichever of both it is.
        self.assertTrue(np.isnan(measures.deviation(coarse[:6], off[:6], fine, 0 * fine, (0, 9))[0]))
        self.assertTrue(np.isnan(measures.deviation(coarse, off, fine[:600], 0 * fine[:600], (0, 9))[0]))
        # A step mean's first value stands half a step after the start.
        self.assertFalse(np.isnan(measures.deviation(coarse[:10] + 0.5, off[:10], fine, 0 * fine, (0, 10))[0]))


class PeelingTest(ScriptTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.newmark = peel(cls.folder / "newmark", "Newmark", 0.1, "Q1C4", ripple=0.01, cost=0.004)
        cls.composite = peel(cls.folder / "composite", "Gautam-Sauer Composite", 0.1, "Q1C4", mean=True, cost=0.005)
        cls.coarse = peel(cls.folder / "coarse", "Newmark", 1.0, cost=0.008, iterations=6)
        cls.short = peel(cls.folder / "short", "Newmark", 0.1, "Q1C4", end=50, status="diverged")

    def altered(self, name, change):
        """A small run with other columns: change(columns by name)."""
        folder = peel(self.folder / name, step=1.0, end=10)
        columns = Run(folder).columns
        change(columns)
        write_history(folder, columns)
        return folder

    def table(self, *arguments):
        """Cells of the Markdown table that summary_table.py prints: (header, rows)."""
        done = script("summary_table.py", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()]
        self.assertEqual(set(lines[1]), {"---"})
        self.assertEqual({len(line) for line in lines}, {len(lines[0])})
        return lines[0], lines[2:]

    def curve(self, folder, **choices):
        usual = {"speed": False, "kinetic": False, "probe": None, "reaction": None, "against": "time", "displacement": None}
        return peeling.Curve(Run(folder), argparse.Namespace(**{**usual, **choices}))

    def test_traits_of_runs(self):
        runs = [Run(folder) for folder in (self.newmark, self.composite, self.coarse, self.short)]
        self.assertEqual([run.element for run in runs], ["Q1C4", "Q1C4", "Q1C1", "Q1C4"])
        self.assertEqual([run.time_step for run in runs], [0.1, 0.1, 1.0, 0.1])
        self.assertEqual(labels(runs[:2]), ["Newmark", "Gautam-Sauer Composite"])
        self.assertEqual(common(runs[:2]), "Q1C4, Δt = 0.1 T₀")
        self.assertEqual(labels(runs[1:3]), ["Gautam-Sauer Composite, Q1C4, Δt = 0.1 T₀", "Newmark, Q1C1, Δt = 1 T₀"])
        self.assertEqual(labels([runs[0], runs[2]]), ["Q1C4, Δt = 0.1 T₀", "Q1C1, Δt = 1 T₀"])
        self.assertEqual(labels([runs[0], runs[3]]), ["newmark", "short"])
        self.assertEqual(labels(runs[:1]), ["Newmark"])
        self.assertEqual(common(runs[:1]), "Newmark, Q1C4, Δt = 0.1 T₀")
        (self.folder / "bare").mkdir()
        write_history(self.folder / "bare", runs[2].columns)
        bare = Run(self.folder / "bare")
        self.assertEqual((bare.element, bare.time_step, labels([bare, runs[2]])[0]), (None, None, "bare"))

    def test_the_force_of_a_step_stands_at_its_middle(self):
        for folder in (self.newmark, self.composite):
            curve = self.curve(folder)
            np.testing.assert_allclose(curve.y[curve.x < START], force(curve.x[curve.x < START]), atol=1e-12)
            self.assertEqual(curve.y_label, "pull-off force [E₀ L₀]")
        self.assertAlmostEqual(self.curve(self.composite).x[0], 0.05)

    def test_displacement_as_abscissa(self):
        time, place = self.curve(self.composite).x, self.curve(self.composite, against="displacement")
        self.assertEqual(place.x_label, "displacement of edge [L₀]")
        late = time > START + 0.1
        np.testing.assert_allclose(place.x[late], time[late] - 20, atol=1e-9)
        other = self.curve(self.composite, against="displacement", displacement="P")
        self.assertAlmostEqual(other.x[-1], 0.5 * Run(self.composite)["P_uy"][-2:].sum(), delta=1e-9)

    def test_speed_is_the_size_of_the_velocity(self):
        curve = self.curve(self.newmark, speed=True)
        self.assertEqual(curve.y_label, "speed of P [L₀/T₀]")
        np.testing.assert_allclose(curve.y, 1.25 * Run(self.newmark)["P_vy"], atol=1e-12)
        edge = self.altered("still", lambda columns: columns.update(edge_vx=0 * columns["time"]))
        np.testing.assert_allclose(self.curve(edge, speed=True, probe="edge").y, Run(edge)["edge_vy"])

    def test_details_fit_what_lies_in_them(self):
        values = self.curve(self.coarse).part(36.5, 38.5)
        self.assertEqual(len(values), 4)
        np.testing.assert_allclose([values.min(), values.max()], force(np.array([36.5, 38.5])), atol=1e-4)
        self.assertEqual(len(self.curve(self.coarse).part(200, 210)), 0)

    def test_peeling_pictures(self):
        png, svg = self.draw("peeling.py", self.newmark, "--zoom", "36,46", "--zoom", "120,140,-0.1,0.2",
                             "--format", "png,svg")
        self.assertEqual((png, svg), (self.newmark / "peeling.png", self.newmark / "peeling.svg"))
        self.assert_picture(png, "PNG", 1300, 1500)
        for label in ("pull-off force [E₀ L₀]", "time [T₀]", "Newmark, Q1C4, Δt = 0.1 T₀"):
            self.assertIn(label, svg.read_text())
        svg, = self.draw("peeling.py", self.newmark, self.composite, self.short, "--reference", self.coarse, "--zoom",
                         "10,30", "--against", "displacement", "--marks", "0,40", "--output", self.folder / "some.svg")
        for label in ("newmark", "short", "Gautam-Sauer Composite", "reference: Newmark, Q1C1, Δt = 1 T₀", "edge [L₀]"):
            self.assertIn(label, svg.read_text())
        svg, = self.draw("peeling.py", self.newmark, "--speed", "--zoom", "100,140", "--format", "svg")
        self.assertEqual(svg, self.newmark / "speed.svg")
        self.assertIn("speed of P [L₀/T₀]", svg.read_text())
        svg, = self.draw("peeling.py", self.coarse, "--reaction", "right_x", "--output", self.folder / "x.svg")
        self.assertIn("reaction right x [E₀ L₀]", svg.read_text())
        history, = self.draw("history.py", self.newmark, self.composite, "--output", self.folder / "history.svg")
        self.assertIn("right y", history.read_text())

    def test_cost(self):
        twice = peel(self.folder / "twice", "Newmark", 0.1, "Q1C4", cost=0.007)
        folders = (self.newmark, self.composite, self.coarse, twice)
        png, svg = self.draw("cost.py", *folders, "--output", self.folder / "cost", "--format", "png,svg")
        self.assert_picture(png, "PNG", 300, 1500)
        for label in ("Newmark", "Gautam-Sauer Composite", "Q1C1", "Q1C4", "Δt = 1 T₀", "Δt = 0.1 T₀", "[ms]"):
            self.assertIn(label, svg.read_text())
        milliseconds, iterations = cost.ROWS.values()
        runs = [cost.checked(folder) for folder in folders]
        for rule, heights in ((milliseconds, [5.5, 5]), (iterations, [4, 4])):
            axes = style.plt.figure().add_subplot()
            cost.draw_bars(axes, [runs[0], runs[1], runs[3]], ["Newmark", "Gautam-Sauer Composite"], ["Q1C4"], rule)
            np.testing.assert_allclose([bar.get_height() for bar in axes.patches], heights)

    def test_table_of_peeling_runs(self):
        header, rows = self.table(self.newmark, self.composite, self.coarse, self.short, "--columns", "peeling")
        self.assertEqual(header, ["scheme", "contact element", "time step", "steps", "Newton iterations a step",
                                  "ms an increment", "ms an iteration", "peak force", "peak at time", "event at peak",
                                  "contact at peak", "detachment time", "status"])
        self.assertEqual(rows[2], ["Newmark", "Q1C1", "1", "150", "6.00", "8", "1.3333", "0.32", "40",
                                   "start of peeling", "150", f"{END:.4g}", "stopped"])
        self.assertEqual(rows[1][:4], ["Gautam-Sauer Composite", "Q1C4", "0.1", "1500"])
        self.assertEqual(rows[1][7:10], ["0.3195", "40.05", "start of peeling"])
        self.assertEqual(rows[1][10], f"{contact(40.05):.4g}")
        self.assertEqual(rows[3][-2:], ["-", "diverged"])
        (self.coarse / "summary.json").rename(self.coarse / "kept")
        rows = self.table(self.coarse, "--columns", "scheme,steps,increment,status")[1]
        self.assertEqual(rows, [["coarse", "-", "-", "-"]])
        (self.coarse / "kept").rename(self.coarse / "summary.json")

    def test_the_largest_force_of_all_steps(self):
        folder = peel(self.folder / "thinned", step=1.0)
        summary = json.loads((folder / "summary.json").read_text())
        for known, expected in ({"reaction_right_y": 0.5}, "0.5"), ({"reaction_right_x": 0.5}, "0.32"), (None, "0.32"):
            (folder / "summary.json").write_text(json.dumps({**summary, "max_force": known}))
            event = "-" if expected == "0.5" else "start of peeling"  # nobody knows that of a step without a row
            self.assertEqual(self.table(folder, "--columns", "peak,event")[1], [[expected, event]])

    def test_the_peak_of_the_beginning(self):
        # The force grows to its peak at 40: up to 30 the last row is the largest, whatever the summary knows.
        rows = self.table(self.coarse, "--columns", "peak-time,peak", "--until", "30")[1]
        self.assertEqual(rows, [["30", f"{force(np.array(30.0)):.4g}"]])

    def test_table_of_oscillations_and_errors(self):
        header, rows = self.table(self.newmark, self.composite, self.coarse, self.short, "--columns", "dt",
                                  "--oscillation", "80,120,4", "--reference", self.composite, "--interval", "80,120")
        self.assertEqual(header, ["time step", "force oscillation", "relative", "force error", "relative"])
        self.assertAlmostEqual(float(rows[0][1]), 0.01 / 2 ** 0.5, delta=5e-4)
        self.assertAlmostEqual(float(rows[0][2]), 0.01 / 2 ** 0.5 / 0.191, delta=3e-3)
        self.assertAlmostEqual(float(rows[0][3]), 0.01 / 2 ** 0.5, delta=1e-4)
        self.assertLess(float(rows[1][1]), 1e-5)
        self.assertEqual(rows[1][3:], ["0", "0"])
        self.assertNotEqual(rows[2][1], "-")  # five rows in the window, no fewer
        self.assertEqual(rows[3][1:], ["-"] * 4)
        rows = self.table(self.coarse, "--columns", "dt", "--oscillation", "80,120,3.9")[1]
        self.assertEqual(rows[0][1:], ["-", "-"])

    def test_table_of_energies_is_as_before(self):
        header, rows = self.table(self.newmark)
        self.assertEqual(header, ["scheme", "status", "end time", "max energy error", "to initial energy",
                                  "to energy scale", "Newton iterations a step", "ms an iteration", "seconds"])
        self.assertEqual(rows, [["Newmark", "stopped", "150", "-", "-", "-", "4.00", "1.0000", "6.00"]])
        summary = json.loads((self.newmark / "summary.json").read_text())
        folder = peel(self.folder / "energies", step=1.0)
        (folder / "summary.json").write_text(json.dumps({**summary, "max_energy_error": 0.25}))
        self.assertEqual(self.table(folder, "--scale", 0.5)[1][0][3:6], ["0.25", "0.25", "0.5"])

    def test_what_is_wrong_is_said_on_one_line(self):
        for name in ("peeling.py", "cost.py", "summary_table.py"):
            self.assert_refused("does not exist", name, self.folder / "none")
            self.assert_refused("unrecognized", name, self.newmark, "--wrong")
        known = "its reactions: reaction_right_x, reaction_right_y"
        self.assert_refused(f"no column 'top_y'; {known}", "peeling.py", self.newmark, "--reaction", "top_y")
        self.assert_refused(f"no column 'top_y'; {known}", "summary_table.py", self.newmark, "--columns", "peak",
                            "--reaction", "top_y")
        self.assert_refused("no column 'Q_vy'; its probes: edge, P", "peeling.py", self.newmark, "--speed", "--probe",
                            "Q")
        self.assert_refused("no column 'Q_uy'", "peeling.py", self.newmark, "--against", "displacement",
                            "--displacement", "Q")
        self.assert_refused("no values of speed of edge", "peeling.py", self.newmark, "--speed", "--probe", "edge")
        self.assert_refused("no run has values from 200 to 210", "peeling.py", self.newmark, "--zoom", "200,210")
        self.assert_refused("no time 151 to mark", "peeling.py", self.newmark, "--marks", "0,151")
        self.assert_refused("--probe needs --speed", "peeling.py", self.newmark, "--probe", "P")
        for wrong in ("5", "5,4", "1,2,3", "1,2,4,3", "1,b"):
            self.assert_refused("--zoom", "peeling.py", self.newmark, "--zoom", wrong)
        for wrong in ("1,2", "2,1,3", "1,2,0", "1,2,x"):
            self.assert_refused("--oscillation", "summary_table.py", self.newmark, "--oscillation", wrong)
        self.assert_refused("unknown column 'peek'", "summary_table.py", self.newmark, "--columns", "dt,peek")
        self.assert_refused("not a number greater than 0", "summary_table.py", self.newmark, "--scale", "0")
        self.assert_refused("needs --reference", "summary_table.py", self.newmark, "--interval", "0,1")
        self.assert_refused("does not cover", "summary_table.py", self.newmark, "--reference", self.short, "--interval",
                            "0,99")
        self.assert_refused("cannot be written", "cost.py", self.newmark, "--output", self.folder / "no" / "such")
        empty = self.altered("empty", lambda columns: columns.pop("reaction_right_y"))
        self.assert_refused("an empty column 'reaction_right_y'", "peeling.py", empty)
        (empty / "summary.json").write_text("{}")
        self.assert_refused("no entry 'seconds_per_increment'", "cost.py", empty)
        scene = empty / "effective.xml"
        scene.write_text(scene.read_text().replace("e+00", "?"))
        self.assert_refused("could not convert", "summary_table.py", empty, "--columns", "dt")
        scene.write_text("<ParameterList>")
        self.assert_refused("effective.xml", "summary_table.py", empty, "--columns", "dt")

    def test_probes_are_not_guessed(self):
        run = Run(self.newmark)
        run.columns["Q_vy"], run.columns["Q_uy"] = run["P_vy"], run["P_uy"]
        self.assertEqual((run.probe("u"), run.probe("v", "Q")), ("edge", "Q"))
        with self.assertRaisesRegex(ResultsError, "several probes, an option must name one: P, Q"):
            run.probe("v")
        del run.columns["edge_uy"]
        with self.assertRaisesRegex(ResultsError, "several probes, an option must name one: P, Q"):
            run.probe("u")
        self.assertEqual(options.zoom("1,2,-3,4"), [1, 2, -3, 4])


if __name__ == "__main__":
    unittest.main()
