#!/usr/bin/python3
"""Runs xml/afm.xml with several cantilevers and xml/afm-rough.xml on several meshes, and compares both with rigid tips.

    docs/cookbook/afm/study.py [--results FOLDER]"""
import math
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as rigid  # noqa: E402
import rough  # noqa: E402

SAMPLE = "Interactions/Sample/"
SCANNED = {SAMPLE + "Obstacle": "Height Field", SAMPLE + "Height Field/File": "afm-rough.gsf",
           SAMPLE + "Height Field/Periodic": "true"}  # a surface from a file, which rough.py writes
TURN = 5  # time at which the base turns


def base(time):
    """Returns the height of the base above the sample, counted at the apex of the tip without load."""
    return 4 + np.sqrt((time - TURN)**2 + 0.01) - math.sqrt(TURN**2 + 0.01)


def approach(stiffness, step, folder):
    """Presses the tip on the sample and pulls it off, on a cantilever of this stiffness."""
    end = rigid.jumps(stiffness)[1][1] + 6.5  # the base is at this height 6 nm later
    return recipe.run("afm", {**recipe.QUIET, "Grips/Cantilever/Stiffness": [0, stiffness],
                              recipe.STEPS + "Time Step": step,
                              recipe.STEPS + "Final Time": step * math.ceil(end / step)}, folder)


def jumps(run, stiffness):
    """Returns the heights of the base half way between the last step before a jump and the first step after it, for
    jump-in and jump-out, and the largest pull of the cantilever."""
    (gap_in, _), (gap_out, _) = rigid.jumps(stiffness)
    between = 0.5 * (gap_in + gap_out)
    inside = run["min_gap"] < between
    first = int(inside.argmax())
    after = first + int((~inside[first:]).argmax())
    heights = base(run["time"])
    return [0.5 * (heights[k - 1] + heights[k]) for k in (first, after)] + [run["reaction_Cantilever_y"].max()]


def scan(divisions, folder, step=0.25, surface=None):
    """Scans a rough surface, by default the waves, with a mesh of so many cells along each direction."""
    settings = {**recipe.QUIET, **(surface or {}), "Mesh/Box/Divisions": [divisions, divisions, 2],
                recipe.STEPS + "Time Step": step}
    return recipe.run("afm-rough", settings, folder)


def compare(file, folder, surface=None):
    """Scans a surface on three meshes, and prints the forces beside those of the reference. Returns the runs."""
    scans = {n: scan(n, folder / str(n), surface=surface) for n in (12, 24, 48)}
    rows = []
    for row in recipe.reference("afm", file):
        at = [int(np.argmin(abs(run["time"] - row["path"]))) for run in scans.values()]
        for axis in "xz":
            exact = row["force_" + axis]
            if abs(exact) > 1e-9:
                forces = [run["contact_force_" + axis][k] for run, k in zip(scans.values(), at)]
                rows.append([f"{row['path']:g}", "lateral" if axis == "x" else "normal", f"{2 * exact:.5f}",
                             *(f"{2 * force:.5f} ({recipe.deviation(force, exact)})" for force in forces)])
    print()
    recipe.table(["path [nm]", "force", "rigid tip [nN]", *(f"{n} cells" for n in scans)], rows)
    return scans


def draw(run, stiffness, scanned):
    """Draws the force over the height of the base, and the force over the path of the scan."""
    picture, (left, right) = recipe.figure(2)
    gaps = np.geomspace(0.203, 12, 600)
    left.plot([rigid.base(gap, stiffness) for gap in gaps], [2 * rigid.force(gap) for gap in gaps], ":",
              color=recipe.style.INK, label="rigid tip, all equilibria")
    down, heights = run["time"] <= TURN, base(run["time"])
    for part, color, label in ((down, 0, "approach"), (~down, 1, "retraction")):
        left.plot(heights[part][1:], -2 * run["reaction_Cantilever_y"][part][1:], color=recipe.style.COLORS[color],
                  label=label)
    left.set(xlabel="height of the base [nm]", ylabel="force on the tip [nN]", xlim=(-1.2, 12))
    left.legend(loc="lower left", fontsize=7)
    path = np.linspace(0, 16, 65)
    exact = np.array([rough.force(x) for x in path])
    for column, factor, color, label in (("x", 10, 1, "lateral, 10 times"), ("z", 1, 0, "normal")):
        right.plot(path, 2 * factor * exact[:, "xyz".index(column)], ":", color=recipe.style.INK)
        right.plot(scanned["time"][1:], -2 * factor * scanned[f"reaction_Holder_{column}"][1:],
                   color=recipe.style.COLORS[color], label=label)
    right.set(xlabel="path of the scan [nm]", ylabel="force on the tip [nN]", ylim=(-0.3, 0.3))
    right.legend(loc="upper right", ncols=2, fontsize=7)
    recipe.save(picture, "afm")


def main():
    folder = recipe.arguments(__doc__).results
    rows, runs = [], {}
    for row in recipe.reference("afm"):
        k = row["stiffness"]
        runs[k] = approach(k, 0.01, folder / f"{k:g}")
        height_in, height_out, pull = jumps(runs[k], k)
        rows.append([f"{2 * k:g}", f"{row['base_in']:.3f}", f"{height_in:.3f}", f"{row['base_out']:.3f}",
                     f"{height_out:.3f}", recipe.deviation(height_out, row["base_out"]), f"{2 * row['force_out']:.4f}",
                     f"{2 * pull:.4f}", recipe.deviation(pull, row["force_out"])])
    recipe.table(["stiffness [N/m]", "base at jump-in, rigid tip [nm]", "Ixos", "base at jump-out, rigid tip [nm]",
                  "Ixos", "difference", "largest pull, rigid tip [nN]", "Ixos", "difference"], rows)
    waves = compare("rough.csv", folder / "rough")
    compare("scan.csv", folder / "scan", SCANNED)
    draw(runs[0.1], 0.1, waves[24])


if __name__ == "__main__":
    main()
