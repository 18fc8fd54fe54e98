#!/usr/bin/python3
"""Runs xml/jkr.xml over Tabor numbers, meshes and geometries, and xml/jkr-spheres.xml over Tabor numbers. Prints the
tables of jkr.md and draws jkr.png.

    docs/cookbook/jkr/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
from half_space import RADIUS, modulus  # noqa: E402

POISSON = 0.3
UNIT = np.pi * RADIUS * recipe.WORK  # of forces: pi R W


def travel(tabor):
    """Returns the distance of the start from the equilibrium gap, and the way down."""
    return 1.5 + 0.5 * tabor, 1.5 + 1.4 * tabor


def settings(tabor, cell=1.0):
    """Returns the changes of the scene for a Tabor number and a width of the cells at the contact."""
    gap, way = travel(tabor)
    return {"Materials/Sphere/Young's Modulus": modulus(tabor) * (1 - POISSON ** 2),
            "Mesh/Box/Divisions": [round(92 / cell), round(22 / cell)],
            "Mesh/Map/Y": f"{recipe.EQUILIBRIUM_GAP + gap!r} + 5*(exp(y/5) - 1) + "
                          "(x < 70 ? x : 65 + 5*exp((x - 70)/5))^2/2000",
            "Histories/Down and Up/Table/Values": [0.0, -way, 0.0], "Output/Checkpoint/Keep": 0}


class Pull:
    """Approach, force and contact radius of a run, and their values at the pull-off."""

    def __init__(self, run, tabor, force, radius):
        gap, way = travel(tabor)
        self.time, self.force, self.radius = run["time"], force, radius
        self.approach = way * (1 - (self.time - 1) ** 2) - gap
        # The lowest force after the turn
        i = len(self.time) // 2 + int(self.force[len(self.time) // 2:].argmin())
        moment, lowest = recipe.vertex(self.time, self.force, i)
        self.pull_off, self.pull_off_radius = -lowest, float(np.interp(moment, self.time, self.radius))


def sphere(tabor, cell, folder):
    """Runs the sphere and returns its Pull."""
    run = recipe.run("jkr", settings(tabor, cell), folder)
    return Pull(run, tabor, run["contact_force_y"], np.sqrt(run["contact_measure"] / np.pi))


def cylinder(tabor, cell, folder):
    """Runs the section of a cylinder in plane strain, of which the mesh is one half, and returns its Pull."""
    run = recipe.run("jkr", {**settings(tabor, cell), **recipe.HALF_SECTION}, folder)
    return Pull(run, tabor, 2 * run["contact_force_y"], run["contact_measure"])


def spheres(tabor, cell, folder):
    """Runs two spheres of the radius and twice the modulus that a sphere of half the radius on a wall would have, and
    returns their Pull."""
    gap, way = travel(tabor)
    surface = f"({recipe.EQUILIBRIUM_GAP + gap!r})/2 + (x < 70 ? x : 65 + 5*exp((x - 70)/5))^2/2000"
    changes = {"Histories/Down and Up/Table/Values": [0.0, -way / 2, 0.0],
               "Histories/Up and Down/Table/Values": [0.0, way / 2, 0.0],
               "Mesh/Parts/upper/Map/Y": f"{surface} + 5*(exp(y/5) - 1)",
               "Mesh/Parts/lower/Map/Y": f"-({surface}) - 5*(exp(-y/5) - 1)", "Output/Checkpoint/Keep": 0}
    for part, body in ("upper", "Upper"), ("lower", "Lower"):
        changes[f"Mesh/Parts/{part}/Box/Divisions"] = [round(92 / cell), round(22 / cell)]
        changes[f"Materials/{body}/Young's Modulus"] = 2 ** 0.5 * modulus(tabor) * (1 - POISSON ** 2)
    run = recipe.run("jkr-spheres", changes, folder)
    return Pull(run, tabor, run["contact_force_y"], np.sqrt(run["contact_measure"] / np.pi))


def jkr(tabor):
    """Returns approach, force over pi R W and contact radius of the theory, from the instability on."""
    stiffness = modulus(tabor)
    a = np.linspace((np.pi * recipe.WORK * RADIUS ** 2 / (8 * stiffness)) ** (1 / 3), 95, 400)
    force = 4 * stiffness * a ** 3 / (3 * RADIUS) - np.sqrt(8 * np.pi * stiffness * recipe.WORK * a ** 3)
    return a ** 2 / RADIUS - np.sqrt(2 * np.pi * recipe.WORK * a / stiffness), force / UNIT, a


def jkr_cylinder(tabor):
    """Returns the pull-off force of a cylinder per length, and half of the contact width there (Barquins 1988)."""
    stiffness = modulus(tabor)
    return (0.75 * (4 * np.pi * stiffness * RADIUS * recipe.WORK ** 2) ** (1 / 3),
            (2 * RADIUS ** 2 * recipe.WORK / (np.pi * stiffness)) ** (1 / 3))


def draw(pulls):
    """Draws force and contact radius over the approach; lengths in the units in which JKR has one curve."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.3)
    for tabor, pull in pulls.items():
        label = f"Tabor number {tabor:g}"
        left.plot(pull.approach / tabor, pull.force / UNIT, label=label)
        right.plot(pull.approach / tabor, pull.radius / tabor ** 0.5, label=label)
    approach, force, radius = jkr(1.0)
    left.plot(approach, force, "k--", label="JKR")
    right.plot(approach, radius, "k--", label="JKR")
    left.axhline(-2, color="k", linestyle=":", label="Bradley, $-2$")
    left.set(xlim=(-1.5, 0.6), ylim=(-2.1, 1.8), xlabel="approach / Tabor number [nm]", ylabel="force / $\\pi R W$ [-]")
    right.set(xlim=(-1.5, 0.6), ylim=(0, 42), xlabel="approach / Tabor number [nm]",
              ylabel="contact radius / Tabor number$^{1/2}$ [nm]")
    left.legend(loc="upper left", fontsize=7)
    recipe.save(picture, "jkr")


def main():
    results = recipe.arguments(__doc__).results
    rows, pulls = [], {}
    for known in recipe.reference("jkr"):
        tabor = known["tabor"]
        runs = [sphere(tabor, cell, results / f"{tabor:g}-{cell:g}") for cell in (2.0, 1.0, 0.5)]
        pulls[tabor] = runs[1]
        rows.append([f"{tabor:g}", f"{known['pull_off']:.4f}", *(f"{run.pull_off / UNIT:.4f}" for run in runs),
                     recipe.deviation(runs[1].pull_off / UNIT, known["pull_off"]), f"{known['radius']:.2f}",
                     f"{runs[1].pull_off_radius:.2f}"])
    recipe.table(["Tabor number", "reference", "cells of 2 nm", "1 nm", "0.5 nm", "difference (1 nm)",
                  "contact radius, reference [nm]", "measured (1 nm)"], rows)
    draw(pulls)
    print("\nTwo spheres\n")
    rows = []
    for known in recipe.reference("jkr"):
        if not 0.5 <= known["tabor"] <= 3:
            continue
        run, radius = spheres(known["tabor"], 1.0, results / f"spheres-{known['tabor']:g}"), known["radius"] / 2 ** 0.5
        rows.append([f"{known['tabor']:g}", f"{known['pull_off']:.4f}", f"{2 * run.pull_off / UNIT:.4f}",
                     recipe.deviation(2 * run.pull_off / UNIT, known["pull_off"]), f"{radius:.2f}",
                     f"{run.pull_off_radius:.2f}"])
    recipe.table(["Tabor number", "reference", "measured", "difference", "contact radius, reference [nm]", "measured"],
                 rows)
    print("\nCylinder, plane strain\n")
    rows = []
    for tabor in 1.0, 3.0, 5.0:
        (force, width), run = jkr_cylinder(tabor), cylinder(tabor, 1.0, results / f"cylinder-{tabor:g}")
        rows.append([f"{tabor:g}", f"{force:.4f}", f"{run.pull_off:.4f}", recipe.deviation(run.pull_off, force),
                     f"{width:.2f}", f"{run.pull_off_radius:.2f}"])
    recipe.table(["Tabor number", "JKR, force per length [E0 L0]", "measured", "difference", "JKR, half width [nm]",
                  "measured"], rows)


if __name__ == "__main__":
    main()
