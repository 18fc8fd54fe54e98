#!/usr/bin/python3
"""Tests of units.py and pull.py on made-up results: tests/plot/units_test.py"""
import json
import re
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True
from scripts import ScriptTest  # noqa: E402 (sets the path to the others)
from synthetic import peel, write_history  # noqa: E402

import measures  # noqa: E402
import pull  # noqa: E402
import style  # noqa: E402
import units  # noqa: E402
from results import ResultsError, Run, flat_wall  # noqa: E402

MOTION = """<ParameterList name="{0}"><Parameter name="Node Set" value="right"/>
  <Parameter name="Components" value="{1}"/><Parameter name="History" value="{2}"/></ParameterList>"""
RAMP = """<ParameterList name="{0}"><Parameter name="Type" value="Rate Ramp"/>
  <ParameterList name="Rate Ramp"><Parameter name="Rate" value="{1}"/></ParameterList></ParameterList>"""


class UnitsTest(ScriptTest):
    def tearDown(self):
        units._shown = None

    def scene(self, name, *lists):
        """A peeling run whose scene has these lists too."""
        folder = peel(self.folder / name)
        path = folder / "effective.xml"
        path.write_text(path.read_text().replace('<ParameterList name="Interactions">',
                                                 "".join(lists) + '<ParameterList name="Interactions">'))
        return folder

    def measured(self, name, length, stress, time):
        """A peeling run with these units."""
        folder = peel(self.folder / name)
        path = folder / "summary.json"
        scales = {"length": length, "stress": stress, "time": time}
        path.write_text(json.dumps({**json.loads(path.read_text()),
                                    "units": {kind: {"si": si} for kind, si in scales.items()}}))
        return folder

    def test_scene_units_stay_without_the_option(self):
        for quantity, dimension, name in (("force", 2, "E₀ L₀"), ("force", 3, "E₀ L₀²"), ("energy", 3, "E₀ L₀³"),
                                          ("speed", 2, "L₀/T₀"), ("measure", 2, "L₀"), ("time", 2, "T₀"),
                                          ("acceleration", 3, "L₀/T₀²")):
            self.assertEqual(units.name(quantity, dimension), name)
        folder = self.measured("plain", 1e-9, 2e9, 1e-9)
        self.assertEqual(Run(folder)["time"][1], 0.1)

    def test_a_wall_that_moves_has_no_height(self):
        def height(name, entries):
            folder = peel(self.folder / name)
            (folder / "effective.xml").write_text(
                '<ParameterList><ParameterList name="Interactions"><ParameterList name="Wall">'
                '<Parameter name="Point" value="{0, 3}"/><ParameterList name="Motion">'
                f'{entries}</ParameterList></ParameterList></ParameterList></ParameterList>')
            return flat_wall(folder)
        still = '<Parameter name="Translation" value="{}"/><Parameter name="Rotation" value=""/>'
        self.assertEqual(height("still", still), 3)
        self.assertEqual(height("no_motion", ""), 3)
        self.assertIsNone(height("pressed", still.replace("{}", "{-, Press}")))
        self.assertIsNone(height("turned", still.replace('"Rotation" value=""', '"Rotation" value="Turn"')))

    def test_a_wall_at_an_angle_has_a_point_and_a_normal(self):
        folder = peel(self.folder / "oblique")
        (folder / "effective.xml").write_text(
            '<ParameterList><ParameterList name="Interactions"><ParameterList name="Wall">'
            '<Parameter name="Point" value="{1, 3}"/><Parameter name="Normal" value="{-3, 4}"/>'
            '</ParameterList></ParameterList></ParameterList>')
        point, normal = flat_wall(folder)
        np.testing.assert_allclose(point, [1, 3])
        np.testing.assert_allclose(normal, [-0.6, 0.8])
        figure, axes = style.plt.subplots()
        axes.set(xlim=(-10, 10), ylim=(-10, 10))
        style.draw_wall(axes, (point, normal))
        line, = axes.lines
        ends = np.array(line.get_data()).T
        np.testing.assert_allclose((ends - point) @ normal, 0, atol=1e-12)
        self.assertAlmostEqual(max(abs(ends).ravel()), 10)
        area, = axes.patches
        self.assertTrue(((area.get_xy() - point) @ normal < 1e-12).all())  # behind the wall
        style.plt.close(figure)

    def test_a_pair_of_bodies_has_no_wall(self):
        folder = peel(self.folder / "pair")
        (folder / "effective.xml").write_text(
            '<ParameterList><ParameterList name="Interactions"><ParameterList name="Contact">'
            '<Parameter name="Primary Side Set" value="left_surface"/></ParameterList></ParameterList></ParameterList>')
        self.assertIsNone(flat_wall(folder))

    def test_prefixes_keep_numbers_readable(self):
        folder = self.measured("nano", 1e-9, 2e9, 1e-9)
        units.use_si(folder)
        names = {(quantity, dimension): units.name(quantity, dimension) for quantity in units.QUANTITIES
                 for dimension in (2, 3)}
        self.assertEqual([names[q] for q in (("time", 2), ("length", 3), ("speed", 2), ("stress", 3), ("measure", 3))],
                         ["ns", "nm", "m/s", "GPa", "nm²"])
        self.assertEqual(names["acceleration", 3], "Gm/s²")  # L0/T0^2 = 1e9 m/s^2
        # E0 L0 = 2 N/m; E0 L0^2 = 2 nJ/m, or 2 nN; E0 L0^3 = 2e-18 J; E0 L0^2 T0 = 2e-18 N s.
        self.assertEqual([names[q] for q in (("force", 2), ("energy", 2), ("force", 3), ("energy", 3), ("momentum", 3))],
                         ["N/m", "nJ/m", "nN", "aJ", "aN s"])

    def test_columns_are_converted(self):
        folder = self.measured("micro", 0.5e-6, 3e6, 2e-6)
        plain = Run(folder)
        units.use_si(folder)
        run = Run(folder)
        # Seen in us, nm, m/s (L0/T0 = 0.25 m/s = 250 mm/s), mm/s, N/m (E0 L0 = 1.5 N/m) and uJ/m (E0 L0^2 = 0.75 uJ/m).
        for column, factor in (("time", 2.0), ("time_step", 2.0), ("contact_measure", 500.0), ("P_uy", 500.0),
                               ("P_vy", 250.0), ("reaction_right_y", 1.5), ("total_energy", 750.0),
                               ("newton_iterations", 1.0)):
            np.testing.assert_allclose(run[column], factor * plain[column], rtol=1e-13, err_msg=column)
        self.assertEqual(units.name("length", 2), "nm")
        self.assertEqual(units.name("energy", 2), "nJ/m")
        self.assertIn("Δt = 0.2 µs", run.traits())
        svg, = self.draw("peeling.py", folder, "--si", "--format", "svg")
        self.assertIn("pull-off force [N/m]", svg.read_text())
        self.assertIn("time [µs]", svg.read_text())

    def test_columns_and_fields_of_single_interactions(self):
        def quantity(column):
            return next((kind for pattern, kind in units.COLUMNS if re.fullmatch(pattern, column)), None)
        for column, expected in (("contact_force_Upper wall_x", "force"), ("contact_moment_Wall_z", "moment"),
                                 ("contact_measure_Wall", "measure"), ("min_gap_Wall", "length"),
                                 ("moment_Jaw_z", "moment"), ("friction_force_Wall_x", "force"),
                                 ("mean_slip_Upper wall", "length"), ("sliding_measure_Wall", "measure"),
                                 ("sticking_measure_Wall", "measure"), ("dissipated_friction_of_Wall", "energy"),
                                 ("dissipated_damping", "energy"), ("norm_displacement", "length"),
                                 ("norm_velocity", "speed"), ("norm_acceleration", "acceleration"),
                                 ("norm_stress", "stress"), ("norm_von_mises_stress", "stress"),
                                 ("norm_energy_density", "stress"), ("norm_dissipated_energy_density", "stress"),
                                 ("norm_jacobian", None), ("contact_force_y", "force"), ("P_ux", "length"),
                                 ("angular_momentum_z", "angular momentum"), ("newton_iterations", None)):
            self.assertEqual(quantity(column), expected, column)
        self.assertEqual([units.name("moment", dimension) for dimension in (2, 3)], ["E₀ L₀²", "E₀ L₀³"])
        for field, expected in (("gap_Wall", "length"), ("slip_Wall", "length"), ("pressure_Wall", "stress"),
                                ("traction_Wall", "stress"), ("friction_Wall", "stress"),
                                ("interaction_traction", "stress"), ("von_mises_stress", "stress"),
                                ("sliding_Wall", None), ("dissipated_Wall", "surface energy"),
                                ("dissipated_energy_density", "stress"), ("damage_pressure plate", None),
                                ("normal_Wall", None), ("damage_stress plate", None),
                                ("normal_pressure plate", None), ("gap", "length"), ("displacement", "length"),
                                ("velocityX", "speed"), ("accelerationZ", "acceleration")):
            self.assertEqual(units.field_quantity(field), expected, field)

    def test_runs_without_units_are_refused(self):
        folder = peel(self.folder / "old")
        self.assert_refused("it has no units", "history.py", folder, "--si")
        (folder / "summary.json").unlink()
        self.assert_refused("--si needs this file", "history.py", folder, "--si")

    def pulled(self, name, motions, ramps):
        return Run(self.scene(name, '<ParameterList name="Boundary Conditions">', *motions, "</ParameterList>",
                              '<ParameterList name="Histories">', *ramps, "</ParameterList>"))

    def test_the_force_along_an_oblique_pull(self):
        along_y = self.pulled("y", [MOTION.format("A", "y", "H")], [RAMP.format("H", 1)])
        self.assertEqual(list(pull.direction(along_y)[1]), [0, 1])
        self.assertEqual(pull.force(along_y)[0], "pull-off force")
        both = self.pulled("xy", [MOTION.format("A", "xy", "H")], [RAMP.format("H", 1)])
        kind, times, values = pull.force(both)
        self.assertEqual(kind, "force along the pull (0.71, 0.71)")
        # The force along x is a tenth of that along y.
        np.testing.assert_allclose(values, 1.1 * both.reaction("right_y")[2] / 2 ** 0.5, rtol=1e-14)
        steep = self.pulled("steep", [MOTION.format("A", "x", "G"), MOTION.format("B", "y", "H")],
                            [RAMP.format("G", -3), RAMP.format("H", 4)])
        np.testing.assert_allclose(pull.direction(steep)[1], [-0.6, 0.8], rtol=1e-15)
        self.assertEqual(pull.force(steep, "right_x")[0], "reaction right x")
        self.assertIsNone(pull.direction(self.pulled("held", [], [])))
        unknown = RAMP.format("G", 1).replace("Rate Ramp", "Expression")
        self.assertIsNone(pull.direction(self.pulled("curve", [MOTION.format("A", "x", "G"), MOTION.format("B", "y", "H")],
                                                     [unknown, RAMP.format("H", 4)])))
        svg, = self.draw("peeling.py", both.folder, "--format", "svg")
        self.assertIn("force along the pull (0.71, 0.71) [E₀ L₀]", svg.read_text())

    def test_peaks_name_their_event(self):
        self.assertEqual([measures.event(part, 10) for part in (10, 6, 4, 0.5, 0)],
                         ["start of peeling", "start of peeling", "peeling", "snap-off", "detached"])
        self.assertIsNone(measures.event(0, 0))
        folder = self.folder / "events"
        folder.mkdir()
        write_history(folder, {"time": np.arange(6.0), "step": np.arange(6.0), "time_step": np.ones(6),
                               "total_energy": np.zeros(6), "contact_measure": np.array([10, 9, 5, 1, 0.5, 0]),
                               "reaction_right_y": np.array([0, 3, 2, 1, 4, 5.0])})
        run = Run(folder)
        name, times, values = run.reaction()
        for event, expected in (("start of peeling", (1, 3)), ("peeling", (2, 2)), ("snap-off", (4, 4))):
            self.assertEqual(measures.event_peak(event, times, values, run["time"], run["contact_measure"]), expected)
        lines = self.draw("summary_table.py", folder, "--columns", "peak,event,start,start-time,snap-off,snap-off-time")
        self.assertEqual(str(lines[-1]), "| 5 | detached | 3 | 1 | 4 | 4 |")


if __name__ == "__main__":
    unittest.main()
