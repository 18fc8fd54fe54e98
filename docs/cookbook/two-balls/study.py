#!/usr/bin/python3
"""Runs xml/two-balls.xml: head-on over speeds, beside one ball before a wall, and off centre with two steps. Prints the
tables of two-balls.md and draws two-balls.png.

    docs/cookbook/two-balls/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as formulas  # noqa: E402

SPEEDS = 10.0, 13.0, 16.0, 20.0, 40.0, 80.0  # of each ball [nm/ns]
STEP = 0.001
BALLS = "Mesh/Parts/{}/Disk/"


def balls(speed, offset, step=STEP, core=8, rings=2):
    """Returns the settings of two balls, off centre by a distance, that start at a gap of 1 nm along x."""
    path = {name: BALLS.format(name) for name in ("left", "right")}
    return {**recipe.QUIET, "Output/Fields Interval": 0,
            **{path[name] + "Core Divisions": core for name in path}, **{path[name] + "Rings": rings for name in path},
            path["right"] + "Center": [11.0, offset], "Initial Conditions/Left/Velocity": [speed, 0.0],
            "Initial Conditions/Right/Velocity": [-speed, 0.0], recipe.STEPS + "Time Step": step,
            "Output/Probes/right/Point": [11.0, offset]}


def duration(speed):
    """Returns the time of a head-on run: until a ball that rebounds is far away."""
    return {recipe.STEPS + "Final Time": round((0.15 + 3 / speed) / 0.01) * 0.01}


def before_a_wall():
    """Returns the settings that replace the left ball by a wall in the middle of the gap, with half of the law's length
    and work: its energy is half of that of twice the gap. The left ball feels nothing and flies away."""
    contact = "Interactions/Contact/"
    return {contact + "Primary Side Set": "", contact + "Normal": [1.0, 0.0], contact + "Point": [5.5, 0.0],
            contact + "Gamma L": 5.0, "Initial Conditions/Left/Velocity": [-1000.0, 0.0]}


def restitution(run, walls=1):
    """Returns the speed far away after the impact over that before it; 0 if the balls stay.

    walls: number of balls that the contact's energy belongs to. The mean speed of the right ball's centre over the last
    part of the run leaves its vibration out."""
    last = run["time"] > run["time"][-1] - 0.1
    speed = np.polyfit(run["time"][last], run["right_ux"][last], 1)[0]
    before = formulas.MASS / 2 * run["right_vx"][0] ** 2 + run["contact_energy"][0] / walls
    after = formulas.MASS / 2 * speed ** 2 + run["contact_energy"][last].mean() / walls
    return (max(after, 0) / before) ** 0.5 if speed > 0 else 0.0


def head_on(folder):
    """Runs two balls, and one before a wall, and prints their table. Returns both restitutions over the speed."""
    rows, points = [], []
    for speed in SPEEDS:
        pair = recipe.run("two-balls", {**balls(speed, 0.0), **duration(speed)}, folder / f"pair-{speed:g}")
        wall = recipe.run("two-balls", {**balls(speed, 0.0), **duration(speed), **before_a_wall()},
                          folder / f"wall-{speed:g}")
        points.append((speed, restitution(pair, 2), restitution(wall)))
        rows.append([f"{speed:g}", f"{points[-1][1]:.3f}", f"{points[-1][2]:.3f}",
                     f"{pair['contact_energy'].min():.5f}", f"{2 * wall['contact_energy'].min():.5f}",
                     f"{pair.energy_error().max() / pair['kinetic_energy'][0]:.0e}"])
    recipe.table(["speed [nm/ns]", "restitution, two balls", "one ball, wall", "least energy of the contact, two balls",
                  "twice that of one ball", "energy error, share"], rows)
    return points


def conservation(folder):
    """Runs balls off centre with two steps and prints the table of what is kept. Returns the last run."""
    rows = []
    for step in 0.002, 0.001:
        settings = {**balls(10.0, 4.0, step), recipe.STEPS + "Final Time": 0.4}
        run = recipe.run("two-balls", settings, folder / f"{step:g}")
        momentum = 2 * formulas.MASS * 10
        linear = np.hypot(run["linear_momentum_x"], run["linear_momentum_y"]).max() / momentum
        angular = np.abs(run["angular_momentum_z"] - run["angular_momentum_z"][0]).max() / abs(
            run["angular_momentum_z"][0])
        rows.append([f"{step:g}", f"{run.energy_error().max() / recipe.WORK:.0e}", f"{linear:.0e}", f"{angular:.1e}"])
    print()
    recipe.table(["step [ns]", "energy error over W L0", "linear momentum over m v of both", "angular momentum, share"],
                 rows)
    return run


def draw(points, run):
    """Draws the restitution over the speed, and energies of an impact off centre over time."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.0)
    speeds, pair, wall = zip(*points)
    left.plot(speeds, pair, "o", markersize=5, color=recipe.style.COLORS[0], label="two balls")
    left.plot(speeds, wall, "x", markersize=5, color=recipe.style.COLORS[1], label="one ball before a wall")
    left.set(xscale="log", xlabel="speed of each ball [nm/ns]", ylabel="restitution", ylim=(-0.03, 1.03))
    left.set_xticks(speeds, [f"{speed:g}" for speed in speeds])
    left.minorticks_off()
    left.legend(fontsize=7)
    for name in ("kinetic", "elastic", "contact"):
        right.plot(run["time"], run[name + "_energy"], linewidth=0.8, label=name)
    right.plot(run["time"], run["total_energy"], color=recipe.style.INK, label="sum")
    right.set(xlabel="time [ns]", ylabel="energy [$E_0 L_0^2$], 4 nm off centre")
    right.set(ylim=(-0.065, 0.085))
    right.legend(fontsize=7, ncols=4, loc="upper center")
    recipe.save(picture, "two-balls")


def main():
    folder = recipe.arguments(__doc__).results
    points = head_on(folder)
    draw(points, conservation(folder))


if __name__ == "__main__":
    main()
