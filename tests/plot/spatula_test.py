#!/usr/bin/python3
"""Tests of what the spatula's pictures need, on folders made from formulas: tests/plot/spatula_test.py"""
import argparse
import json
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True
from scripts import ScriptTest  # noqa: E402 (sets the path to the others)
import increments  # noqa: E402
import peeling  # noqa: E402
import results  # noqa: E402
import style  # noqa: E402
import vibration  # noqa: E402
from results import ResultsError, Run, common, labels  # noqa: E402
from synthetic import write_history  # noqa: E402

SCENE = """<ParameterList name="Spatula">
  <ParameterList name="Materials"><ParameterList name="Keratin">
    <Parameter name="Stiffness Damping" type="double" value="{damping}"/>
  </ParameterList></ParameterList>
  <ParameterList name="Interactions">{interaction}</ParameterList>
  <ParameterList name="Histories"><ParameterList name="Pull">
    <Parameter name="Type" type="string" value="Rate Ramp"/>
    <ParameterList name="Rate Ramp">
      <Parameter name="Rate" type="double" value="2"/><Parameter name="Start" type="double" value="1"/>
      <Parameter name="Length" type="double" value="20"/><Parameter name="Shape" type="string" value="{shape}"/>
    </ParameterList>
  </ParameterList></ParameterList>
  <ParameterList name="Boundary Conditions">
    <ParameterList name="Guide"><Parameter name="Components" type="string" value="xy"/></ParameterList>
    <ParameterList name="Lift"><Parameter name="History" type="string" value="Pull"/></ParameterList>
  </ParameterList>
  <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
    <Parameter name="Time Step" type="double" value="0.5"/>
  </ParameterList></ParameterList>
  <ParameterList name="Output"><ParameterList name="Probes"><ParameterList name="P">
    <Parameter name="Point" type="Array(double)" value="{{230, 0, 0.25}}"/>
  </ParameterList></ParameterList></ParameterList>
</ParameterList>
"""
COLUMNS = ("step time time_step kinetic_energy total_energy linear_momentum_x linear_momentum_y linear_momentum_z "
           "newton_iterations wall_seconds reaction_end_z P_ux P_uy P_uz P_vx P_vy P_vz").split()


def pull(folder, scheme="Newmark", damping="0.004", shape="Cosine", seconds=0.2, iterations=4, wall=True, end=40.0):
    """A results folder of a body in space; each step takes `seconds` and `iterations`, those after 20 T0 twice both."""
    folder.mkdir(parents=True, exist_ok=True)
    time = np.arange(0, end + 0.25, 0.5)
    factor = np.where(time > 20, 2, 1) * (time > 0)
    write_history(folder, {
        "step": np.arange(len(time)), "time": time, "time_step": np.where(time > 0, 0.5, 0), "total_energy": 0 * time,
        "kinetic_energy": 0.1 * time, "linear_momentum_z": 0 * time, "newton_iterations": iterations * factor,
        "wall_seconds": np.cumsum(seconds * factor), "reaction_end_z": 0.1 * time, "P_ux": np.cos(time) - 1,
        "P_uy": 0 * time, "P_uz": 10 * np.cos(time), "P_vz": -10 * np.sin(time)}, COLUMNS)
    (folder / "summary.json").write_text(json.dumps({"status": "completed", "scheme": scheme}))
    interaction = '<ParameterList name="Wall"/>' if wall else ""
    (folder / "effective.xml").write_text(SCENE.format(damping=damping, shape=shape, interaction=interaction))
    return folder


class SpatulaTest(ScriptTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.free = pull(cls.folder / "free", damping="0.0e+00", wall=False)
        cls.damped = pull(cls.folder / "damped", wall=False)
        cls.bathe = pull(cls.folder / "bathe", "Bathe Composite", seconds=0.5, iterations=8)

    def curve(self, folder, **choices):
        usual = {"speed": False, "kinetic": False, "reaction": None, "against": "time", "displacement": None}
        return peeling.Curve(Run(folder), argparse.Namespace(**{**usual, **choices}))

    def test_damping_tells_runs_apart(self):
        free, damped, bathe = map(Run, (self.free, self.damped, self.bathe))
        self.assertEqual(labels([free, damped]), ["no damping", "α₂ = 0.004 T₀"])
        self.assertEqual((free.element, bathe.element), (None, "Q1C1"))
        self.assertEqual(common([free, damped]), "Newmark, Δt = 0.5 T₀")
        self.assertEqual(common([free]), "Newmark, Δt = 0.5 T₀")
        self.assertEqual(common([damped]), "Newmark, Δt = 0.5 T₀, α₂ = 0.004 T₀")

    def test_applied_displacement_is_the_integral_of_the_rate(self):
        time = np.linspace(0, 40, 40001)
        tau = np.clip((time - 1) / 20, 0, 1)
        rates = {"Linear": tau, "Cosine": (1 - np.cos(np.pi * tau)) / 2,
                 "Quintic": 10 * tau ** 3 - 15 * tau ** 4 + 6 * tau ** 5}
        for shape, rate in rates.items():
            run = Run(pull(self.folder / shape, shape=shape))
            integral = np.concatenate([[0], np.cumsum(rate[1:] + rate[:-1]) * 0.001])
            np.testing.assert_allclose(run.applied(time), integral, atol=1e-6)
        np.testing.assert_array_equal(results.ramp_integral(np.array([-1.0, 0.0, 2.0]), 0, "Linear"), [0, 0, 2])
        curve = self.curve(self.damped, against="applied")
        self.assertEqual(curve.x_label, "applied displacement [L₀]")
        np.testing.assert_allclose(curve.x, Run(self.damped).applied(curve.times))

    def test_energy_error_of_a_run_with_a_past(self):
        run = Run(self.damped)
        rows = len(run["time"])
        past = {"total_energy": np.linspace(2, 1.5, rows), "external_work": np.full(rows, 2.0),
                "dissipated_energy": 0.1 + np.linspace(0, 0.3, rows), "released_energy": 0.4 + np.linspace(0, 0.2, rows)}
        folder = self.folder / "past"
        folder.mkdir()
        write_history(folder, {**run.columns, **past}, [*COLUMNS, "external_work", "dissipated_energy", "released_energy"])
        np.testing.assert_allclose(Run(folder).energy_error(), 0, atol=1e-12)
        np.testing.assert_allclose(Run(folder, (5, 30)).energy_error(), 0, atol=1e-12)

    def test_kinetic_energy(self):
        curve = self.curve(self.bathe, kinetic=True)
        self.assertEqual(curve.y_label, "kinetic energy [E₀ L₀³]")
        np.testing.assert_allclose(curve.y, 0.1 * curve.x)
        svg, = self.draw("peeling.py", self.bathe, "--kinetic", "--zoom", "20,30", "--format", "svg")
        self.assertEqual(svg, self.bathe / "kinetic.svg")

    def test_force_in_another_unit(self):
        svg, = self.draw("peeling.py", self.damped, self.bathe, "--against", "applied", "--unit", "2,nN", "--zoom",
                         "5,20", "--zoom", "30,40", "--output", self.folder / "force.svg")
        for label in ("pull-off force [E₀ L₀²]", "[nN]", "applied displacement [L₀]"):
            self.assertIn(label, svg.read_text())

    def test_no_stress_is_white(self):
        for limits in ((-0.125, 0.25), (-0.25, 0.25), (-0.25, 0.1)):
            colormap, norm = style.color_scale("first_stress_invariant", np.zeros(1), limits)
            colormap = style.plt.get_cmap(colormap)
            even = style.plt.get_cmap("RdBu_r")
            self.assertEqual((norm.vmin, norm.vmax), limits)
            np.testing.assert_allclose(colormap(norm(0)), even(0.5), atol=0.03)
            for value in (*limits, 0.05):
                np.testing.assert_allclose(colormap(norm(value)), even(0.5 + value / 0.5), atol=0.03)
        self.assertEqual(style.color_scale("jacobian", np.zeros(1), (0.9, 1.2))[0], "YlGnBu")

    def test_cost_of_increments(self):
        times, seconds, iterations = increments.increments(Run(self.bathe))
        np.testing.assert_allclose(times, np.arange(1, 81) * 0.5)
        np.testing.assert_allclose(seconds, np.where(times > 20, 1.0, 0.5))
        np.testing.assert_allclose(iterations, np.where(times > 20, 16, 8))
        # The clock that a restart sets back is no cost.
        run = Run(self.bathe)
        run["wall_seconds"][40:] -= 15
        self.assertEqual(len(increments.increments(run)[0]), 79)
        png, svg = self.draw("increments.py", self.damped, self.bathe, "--output", self.folder / "increments",
                             "--format", "png,svg")
        self.assert_picture(png, "PNG", 1300, 1500)
        for label in ("Newmark", "Bathe Composite", "[s]", "time [T₀]", "iterations"):
            self.assertIn(label, svg.read_text())
        self.draw("increments.py", self.damped, "--time", "5,30", "--logarithmic", "--output", self.folder / "log")

    def test_vibration(self):
        self.assertEqual(vibration.place(Run(self.free), "P"), {"x": 230, "y": 0, "z": 0.25})
        png, svg = self.draw("vibration.py", self.free, self.damped, self.bathe, "--output", self.folder / "vibration",
                             "--format", "png,svg")
        self.assert_picture(png, "PNG", 1300, 1500)
        for label in ("x of P [L₀]", "z of P [L₀]", "no damping", "Bathe Composite", "time [T₀]"):
            self.assertIn(label, svg.read_text())
        svg, = self.draw("vibration.py", self.free, "--components", "y", "--format", "svg")
        self.assertEqual(svg, self.free / "vibration.svg")
        self.assertNotIn("z of P", svg.read_text())

    def test_what_is_wrong_is_said_on_one_line(self):
        for name in ("increments.py", "vibration.py"):
            self.assert_refused("does not exist", name, self.folder / "none")
            self.assert_refused("no rows from time 90", name, self.free, "--time", "90,99")
        self.assert_refused("'xw' may only contain the letters xyz", "vibration.py", self.free, "--components", "xw")
        self.assert_refused("no column 'Q_uz'", "vibration.py", self.free, "--probe", "Q")
        self.assert_refused("not a factor and a name", "peeling.py", self.free, "--unit", "2")
        self.assert_refused("not a number greater than 0", "peeling.py", self.free, "--unit", "0,nN")
        self.assert_refused("not allowed with", "peeling.py", self.free, "--speed", "--kinetic")
        self.assert_refused("--reaction needs a force", "peeling.py", self.free, "--kinetic", "--reaction", "end_z")
        bare = pull(self.folder / "bare")
        (bare / "effective.xml").unlink()
        self.assert_refused("has no motion", "peeling.py", bare, "--against", "applied")
        self.assert_refused("has no position of the probe 'P'", "vibration.py", bare)
        run = Run(self.free)
        run.columns["newton_iterations"][:] = np.nan
        with self.assertRaisesRegex(ResultsError, "empty column 'newton_iterations'"):
            increments.increments(run)


if __name__ == "__main__":
    unittest.main()
