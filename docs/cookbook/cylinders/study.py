#!/usr/bin/python3
"""Runs xml/cylinders.xml over Tabor numbers and meshes. Prints the table of cylinders.md and draws cylinders.png.

    docs/cookbook/cylinders/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as formulas  # noqa: E402

POISSON = 0.3
MESHES = {"scene": {}, "lower: two thirds of the cells": {"Mesh/Parts/lower/Box/Divisions": [48, 15]},
          "half of the cells": {f"Mesh/Parts/{part}/Box/Divisions": [36, 11] for part in ("upper", "lower")}}


def travel(tabor):
    """Returns the distance of the start from the equilibrium gap, and the way down."""
    return 1 + tabor, 1.6 + 1.5 * tabor


def settings(tabor, mesh="scene"):
    """Returns the changes of the scene for a Tabor number and a mesh."""
    gap, way = travel(tabor)
    young = 2 * formulas.modulus(tabor) * (1 - POISSON ** 2)
    return {**recipe.QUIET, **MESHES[mesh], "Materials/Upper/Young's Modulus": young,
            "Materials/Lower/Young's Modulus": young,
            "Mesh/Parts/upper/Map/Y": f"{recipe.EQUILIBRIUM_GAP + gap!r} + 5*(exp(y/5) - 1) + "
                                      "(x < 50 ? x : 45 + 5*exp((x - 50)/5))^2/2000",
            "Histories/Down and Up/Table/Values": [0.0, -way, 0.0]}


class Pull:
    """Approach and force per length of a run, and pull-off force and half width of the contact there."""

    def __init__(self, tabor, folder, mesh="scene"):
        run = recipe.run("cylinders", settings(tabor, mesh), folder)
        gap, way = travel(tabor)
        self.force, self.width = 2 * run["contact_force_y"], run["contact_measure"]
        self.approach = way * (1 - (run["time"] - 1) ** 2) - gap
        i = len(self.force) // 2 + int(self.force[len(self.force) // 2:].argmin())  # after the turn
        moment, lowest = recipe.vertex(run["time"], self.force, i)
        self.pull_off, self.half_width = -lowest, float(np.interp(moment, run["time"], self.width))


def draw(pulls):
    """Draws force and half width of the contact over the approach."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.0)
    for color, (tabor, pull) in zip(recipe.style.COLORS, pulls.items()):
        left.plot(pull.approach, pull.force, color=color, label=f"Tabor number {tabor:g}")
        known = next(row for row in recipe.reference("cylinders") if row["tabor"] == tabor)
        left.axhline(-known["pull_off"], color=color, linestyle=":", linewidth=0.8)
        right.plot(pull.approach, pull.width, color=color, label=f"Tabor number {tabor:g}")
    left.set(xlabel="approach [nm]", ylabel="force per length [2 N/m]", ylim=(-2, 2))
    right.set(xlabel="approach [nm]", ylabel="half width of the contact [nm]")
    left.legend(fontsize=7)
    recipe.save(picture, "cylinders")


def main():
    folder = recipe.arguments(__doc__).results
    rows, pulls = [], {}
    for known in recipe.reference("cylinders"):
        tabor = known["tabor"]
        if not tabor:
            continue
        for mesh in MESHES if tabor == 3 else ["scene"]:
            pull = Pull(tabor, folder / f"{tabor:g}-{mesh[:5]}", mesh)
            pulls.setdefault(tabor, pull)
            rows.append([f"{tabor:g}", mesh, f"{known['jkr']:.4f}", f"{known['pull_off']:.4f}", f"{pull.pull_off:.4f}",
                         recipe.deviation(pull.pull_off, known["pull_off"]), f"{known['half_width']:.2f}",
                         f"{pull.half_width:.2f}"])
    recipe.table(["Tabor number", "mesh", "JKR", "half-planes", "Ixos", "to half-planes",
                  "half width, half-planes [nm]", "Ixos"], rows)
    draw(pulls)


if __name__ == "__main__":
    main()
