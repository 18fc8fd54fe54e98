#!/usr/bin/python3
"""Runs xml/pillar.xml with defects of several radii and compares the pull-off force with Dugdale's model.

    docs/cookbook/pillar/study.py [--results FOLDER]"""
import math
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as dugdale  # noqa: E402

CELLS, NEAR = 60, 30.0  # radial cells; half of them are 1 nm wide at the edge of a large defect


def settings(defect, steps=100, cells=CELLS):
    """Returns the settings of a run with a defect of this radius, to 30 per cent beyond pull-off by Hooke's law."""
    near = min(NEAR, defect)
    inner, outer = defect - near, dugdale.RADIUS - defect - NEAR
    stretch = dugdale.pull_off(defect) / (math.pi * dugdale.RADIUS**2 * dugdale.YOUNG)
    end = round(1.3 * 600 * stretch + 0.3, 1)
    return {"Mesh/Map/X": f"{defect} + (x < 0 ? {near} : {NEAR})*x + (x < 0 ? {inner} : {outer})*x^3",
            "Mesh/Box/Divisions": [cells, cells // 2], "Interactions/Adhesion/Factor": f"x < {defect} ? 0 : 1",
            recipe.STEPS + "Final Time": end, recipe.STEPS + "Time Step": end / steps, **recipe.QUIET}


def pull_off(run):
    """Returns the largest force."""
    return np.nanmax(run["reaction_top_y"])


def draw(runs, forces):
    """Draws the force over the displacement, and the pull-off force over the radius of the defect."""
    picture, (left, right) = recipe.figure(2)
    full = dugdale.strength(0)
    for color, (defect, run) in zip(recipe.style.COLORS, runs.items()):
        left.plot(run["time"][1:], run["reaction_top_y"][1:] / full, color=color, label=f"{defect:g} nm")
    left.set(xlabel="displacement of the top [nm]", ylabel="force / (strength times foot)")
    left.legend(fontsize=7)
    radii = np.geomspace(2, 150, 100)
    for formula, line, label in ((dugdale.pull_off, "-", "Dugdale"), (dugdale.griffith, ":", "Griffith"),
                                 (dugdale.strength, "--", "strength")):
        right.loglog(radii, [formula(c) / full for c in radii], line, color=recipe.style.INK, label=label)
    right.loglog(list(runs), np.array(forces) / full, "o", markersize=4, color=recipe.style.COLORS[0], label="Ixos")
    right.set(xlabel="radius of the defect [nm]", ylabel="pull-off force / (strength times foot)", ylim=(0.2, 2))
    right.legend()
    recipe.save(picture, "pillar")


def main():
    folder = recipe.arguments(__doc__).results
    rows, runs, forces = [], {}, []
    for row in recipe.reference("pillar"):
        defect = int(row["defect"])
        runs[defect] = recipe.run("pillar", settings(defect, steps=400), folder / str(defect))
        force = pull_off(runs[defect])
        forces.append(force)
        rows.append([defect, *(f"{row[key]:.0f}" for key in ("strength", "griffith", "pull_off")), f"{force:.0f}",
                     recipe.deviation(force, row["pull_off"])])
    recipe.table(["radius of the defect [nm]", "strength", "Griffith", "Dugdale", "Ixos", "difference to Dugdale"],
                 rows)
    draw(runs, forces)


if __name__ == "__main__":
    main()
