#!/usr/bin/python3
"""Runs xml/gecko-drag.xml with several frictions and compares the forces with those of a film that slides.

    docs/cookbook/gecko-drag/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as sliding  # noqa: E402

FRICTION, ALONG, UP = "Interactions/Wall/Friction/", "Histories/Along/Expression/", "Histories/Up/Rate Ramp/"
STRESS = 0.001  # threshold of the scene where nothing presses or pulls
STRAIGHT = {ALONG + "Value": "0*t", ALONG + "Velocity": 0.0, UP + "Start": 0.0}  # lifted at 90 degrees without a drag
# kind of friction, threshold, other settings, and how the picture calls it
CASES = (("None", 0.0, {}, "no friction"), ("Extended Amontons", STRESS, {}, "Extended Amontons"),
         ("Constant Stress", STRESS, {}, "Constant Stress"),
         ("Extended Amontons", STRESS, STRAIGHT, "lifted straight"),
         ("Extended Amontons", 0.00025, {}, ""), ("Extended Amontons", 0.0005, {}, ""),
         ("Extended Amontons", 0.002, {}, ""))


def friction(kind, stress):
    """Returns the settings of a friction whose threshold is a stress where nothing presses or pulls."""
    strength = {"Extended Amontons": {"Coefficient": stress / sliding.PEAK}, "Constant Stress": {"Stress": stress},
                "None": {}}[kind]
    # an elastic slip of 0.01 nm
    spring = {"Stiffness": stress / 0.01} if strength else {}
    return {FRICTION + key: value for key, value in {"Type": kind, **strength, **spring}.items()}


def drag(kind, stress, others, folder):
    """Drags and lifts the pad."""
    return recipe.run("gecko-drag", {**recipe.QUIET, **friction(kind, stress), **others}, folder)


def forces(run, bonded=sliding.BONDED):
    """Returns the forces along the wall and away from it while so much of the pad is still bonded."""
    first = int(np.argmax(run["contact_measure"] < bonded))
    if first == 0:
        raise RuntimeError(f"{run.folder}: the pad stays bonded")
    part = [first, first - 1]
    return [float(np.interp(bonded, run["contact_measure"][part], run[f"reaction_right_{axis}"][part]))
            for axis in "xy"]


def draw(runs):
    """Draws the force away from the wall over the path, and over the force along the wall."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.2)
    ink, colors = recipe.style.INK, recipe.style.COLORS
    for (case, run), color, line in zip(runs, colors, ("-", "-", "--", "-")):
        left.plot(run["time"], run["reaction_right_y"], line, color=color, label=case[3])
    left.set(xlabel="t [nm]", xlim=(0, 225), ylabel="force away from the wall [2 N/m]", ylim=(-0.002, 0.082))
    left.legend(loc="upper right")
    tangential = np.linspace(0, 0.165, 200)
    right.plot(tangential, [sliding.normal_force(force) for force in tangential], ":", color=ink,
               label="film that slides")
    chosen = sorted((run for case, run in runs if case[0] == "Extended Amontons" and not case[2]),
                    key=lambda run: run["reaction_right_x"].max())
    for color, run in zip(colors, chosen):
        right.plot(run["reaction_right_x"], run["reaction_right_y"], color=color, linewidth=1,
                   label=f"tau = {run['reaction_right_x'].max() / 80:.2g}")
    right.set(xlabel="force along the wall [2 N/m]", ylabel="force away from the wall [2 N/m]", ylim=(-0.002, 0.13))
    right.legend(loc="upper left")
    recipe.save(picture, "gecko-drag")


def main():
    folder = recipe.arguments(__doc__).results
    expected = {row["stress"]: row for row in recipe.reference("gecko-drag")}
    runs, rows, alone = [], [], None
    for number, case in enumerate(CASES):
        kind, stress, others, _ = case
        run = drag(kind, stress, others, folder / str(number))
        row, (tangential, normal), largest = expected[stress], forces(run), run["reaction_right_y"].max()
        alone = alone or largest
        runs.append((case, run))
        rows.append([kind, "straight" if others else "drag, 30 degrees", f"{stress:g}", f"{row['tangential']:.4f}",
                     f"{tangential:.4f}", f"{row['normal']:.5f}", f"{normal:.5f}",
                     recipe.deviation(normal, row["normal"]), f"{largest:.4f}", f"{largest / alone:.2f}"])
    recipe.table(["friction", "lift", "tau", "tau l", "force along, Ixos", "force away, sliding film", "Ixos",
                  "difference", "largest force away", "over that without friction"], rows)
    draw(runs)


if __name__ == "__main__":
    main()
