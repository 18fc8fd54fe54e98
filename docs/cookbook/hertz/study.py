#!/usr/bin/python3
"""Runs xml/hertz.xml as a sphere, as a cylinder and rigid. Prints the tables of hertz.md and draws hertz.png.

    docs/cookbook/hertz/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np
from scipy.integrate import quad

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402
from exodus import Fields  # noqa: E402 (of drivers/plot, which recipe makes known)

RADIUS, MODULUS = 200.0, 1 / (1 - 0.3 ** 2)  # R, E*
EDGE = 3 + 5 * np.exp(23 / 5)  # radius of the body
CYLINDER = {**recipe.HALF_SECTION, "Histories/Down/Table/Values": [0.0, -0.41]}
RIGID = {"Materials/Body/Young's Modulus": 1e8, "Interactions/Sphere/Law": "Van der Waals",
         "Interactions/Sphere/Sphere/Center": [0.0, -RADIUS - recipe.EQUILIBRIUM_GAP - 0.25],
         "Histories/Down/Table/Values": [0.0, -0.25]}


def finer(factor):
    """Returns the changes for cells that are smaller by a factor."""
    return {"Mesh/Box/Divisions": [124 * factor, 92 * factor]}


def pressures(run):
    """Returns radii and pressures of the surface at the end of a run."""
    fields = Fields(run.folder)
    place, pressure = fields.coordinates, fields.nodal("contact_pressure", len(fields.times) - 1)
    surface = np.isfinite(pressure) & (place[:, 1] < 1e-9)
    order = place[surface, 0].argsort()
    return place[surface, 0][order], pressure[surface][order]


class Dent:
    """Approach, force and contact radius (half of the contact width) of a run, and its largest pressure at the end."""

    def __init__(self, settings, folder):
        run = recipe.run("hertz", settings, folder)
        plane = settings.get("Mesh/Geometry") == "Plane Strain"
        self.approach = 0.11 * run["time"] - 0.01
        self.force = run["contact_force_y"] * (2 if plane else 1)
        self.radius = run["contact_measure"] if plane else np.sqrt(run["contact_measure"] / np.pi)
        self.place, self.pressure = pressures(run)


def sphere(approach):
    """Returns force, contact radius and largest pressure of Hertz's sphere."""
    force, radius = 4 / 3 * MODULUS * RADIUS ** 0.5 * np.maximum(approach, 0) ** 1.5, (RADIUS * approach) ** 0.5
    return force, radius, 2 * MODULUS / np.pi * (approach / RADIUS) ** 0.5


def cylinder(force):
    """Returns half of the contact width and largest pressure of Hertz's cylinder by its force per length."""
    width = (4 * force * RADIUS / (np.pi * MODULUS)) ** 0.5
    return width, 2 * force / (np.pi * width)


def rigid(folder):
    """Runs a rigid flat body before an adhesive sphere. Returns gaps, forces, and the integrals of the law.

    The law acts along the sphere's normal, and r dr = s ds for the distance s = R + g from the centre, so that the
    integral is 2 pi (R + D) [psi(D) - psi(g at the edge)]; without the edge, at the equilibrium gap, 2 pi (R + D) W."""
    run = recipe.run("hertz", RIGID, folder)
    gap = recipe.EQUILIBRIUM_GAP + 0.25 * (1 - run["time"])
    edge = np.sqrt(EDGE ** 2 + (RADIUS + gap) ** 2) - RADIUS
    return gap, run["contact_force_y"], 2 * np.pi * (RADIUS + gap) * (recipe.law(gap)[0] - recipe.law(edge)[0])


def rigid_section(folder):
    """Runs a rigid flat body before an adhesive cylinder. Returns gaps, forces per length, and the integrals of the law
    by quadrature: at x the distance from the axis is s, the gap s - R, and the traction acts along the radius."""
    def pressure(x, height):
        distance = np.hypot(x, height)
        return recipe.law(distance - RADIUS)[1] * height / distance
    run = recipe.run("hertz", {**RIGID, **recipe.HALF_SECTION}, folder)
    gap = recipe.EQUILIBRIUM_GAP + 0.25 * (1 - run["time"])
    half = [quad(pressure, 0, EDGE, args=(RADIUS + g,), points=(2, 5, 10, 20, 50, 100), epsabs=0, epsrel=1e-11)[0]
            for g in gap]
    return gap, 2 * run["contact_force_y"], 2 * np.array(half)


def draw(ball, roll):
    """Draws the force over the approach of the sphere, and the pressures of sphere and cylinder."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.0)
    approach = np.linspace(0, 0.1, 100)
    left.plot(approach, sphere(approach)[0], "k--", label="Hertz")
    left.plot(ball.approach[1:], ball.force[1:], "o", markersize=4, label="Ixos")
    left.set(xlabel="approach [nm]", ylabel="force [$E_0 L_0^2$]")
    left.legend()
    _, radius, largest = sphere(0.1)
    width, highest = cylinder(roll.force[-1])
    for dent, a, p, name in ((ball, radius, largest, "sphere"), (roll, width, highest, "cylinder")):
        x = np.linspace(0, a, 200)
        right.plot(x, p * np.sqrt(1 - (x / a) ** 2), "k--")
        near = dent.place < 1.3 * a
        right.plot(dent.place[near], dent.pressure[near], "o", markersize=3, label=name)
    right.set(xlabel="distance from the middle [nm]", ylabel="pressure [$E_0$]")
    right.legend()
    recipe.save(picture, "hertz")


def main():
    results = recipe.arguments(__doc__).results
    known = {(row["body"], row["quantity"]): row["value"] for row in recipe.reference("hertz")}
    balls = [Dent(finer(factor), results / f"sphere-{factor}") for factor in (1, 2)]
    roll = Dent({**CYLINDER, **finer(2)}, results / "cylinder")
    width, pressure = cylinder(roll.force[-1])
    rows = []
    for quantity, values in (("force", [ball.force[-1] for ball in balls]),
                             ("contact radius", [ball.radius[-1] for ball in balls]),
                             ("largest pressure", [ball.pressure.max() for ball in balls])):
        expected = known["sphere", quantity]
        rows.append(["sphere, " + quantity, f"{expected:.5g}", *(f"{value:.5g}" for value in values),
                     recipe.deviation(values[-1], expected)])
    rows += [["cylinder, half width", f"{width:.5g}", "", f"{roll.radius[-1]:.5g}",
              recipe.deviation(roll.radius[-1], width)],
             ["cylinder, largest pressure", f"{pressure:.5g}", "", f"{roll.pressure.max():.5g}",
              recipe.deviation(roll.pressure.max(), pressure)]]
    recipe.table(["", "Hertz", "cells of 0.25 nm", "0.125 nm", "difference"], rows)
    print()
    rows = []
    for body, run in (("sphere", rigid), ("cylinder", rigid_section)):
        _, force, exact = run(results / f"rigid-{body}")
        rows.append([body, f"{exact[-1]:.9g}", f"{force[-1]:.9g}", f"{np.max(np.abs(force / exact - 1)):.1e}"])
    recipe.table(["rigid and adhesive", "exact, at the equilibrium gap", "measured", "largest difference at all gaps"],
                 rows)
    draw(balls[-1], roll)


if __name__ == "__main__":
    main()
