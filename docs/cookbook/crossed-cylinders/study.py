#!/usr/bin/python3
"""Runs xml/crossed-cylinders.xml over angles and radii. Prints the table of crossed-cylinders.md and draws
crossed-cylinders.png.

    docs/cookbook/crossed-cylinders/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402

CUTOFF = 5.0
START = 3.0  # distance at the beginning
CASES = {"R = 100 nm, 90 degrees": (100.0, 90.0), "R = 200 nm, 90 degrees": (200.0, 90.0),
         "R = 100 nm, 60 degrees": (100.0, 60.0)}
DISTANCES = 2.0, 1.0, 0.48, 0.28  # of recorded rows


def energy(gap):
    """Returns the energy per area of flat surfaces under the law that ends at the cutoff."""
    end, traction, _ = recipe.law(CUTOFF)
    return recipe.law(gap)[0] - end + traction * (gap - CUTOFF)


def derjaguin(distance, radius, angle):
    """Returns the force on the upper cylinder: 2 pi R/sin(angle) times that energy."""
    return 2 * np.pi * radius / np.sin(np.radians(angle)) * energy(distance)


def settings(radius, angle):
    """Returns the changes of the scene. A larger radius or another angle needs wider shells."""
    wide = 40 * np.sqrt(radius / 100 / (1 - abs(np.cos(np.radians(angle)))))
    c, s = float(np.cos(np.radians(angle))), float(np.sin(np.radians(angle)))  # NumPy 2 writes its own otherwise
    changes = {"Mesh/Parts/upper/Map/Z": f"3 + z + x^2/{2 * radius!r}",
               "Mesh/Parts/lower/Map/Z": f"z - ({c!r}*x - {s!r}*y)^2/{2 * radius!r}"}
    for part, height in ("upper", 0.0), ("lower", -1.0):
        changes[f"Mesh/Parts/{part}/Box/Lower"] = [-wide, -wide, height]
        changes[f"Mesh/Parts/{part}/Box/Lengths"] = [2 * wide, 2 * wide, 1.0]
    return changes


def approach(radius, angle, folder, last=None):
    """Runs a case, to that time if one is given. Returns distances and forces on the upper cylinder."""
    changes = {**recipe.QUIET, **settings(radius, angle)}
    if last is not None:
        changes["Time Integrator/Time Step Control/Final Time"] = last
    run = recipe.run("crossed-cylinders", changes, folder)
    return START - run["time"], run["contact_force_z"]


def main():
    results, rows = recipe.arguments(__doc__).results, []
    picture, axes = recipe.figure(1, 5.6, 3.2)
    for name, (radius, angle) in CASES.items():
        distance, force = approach(radius, angle, results / f"{radius:g}-{angle:g}")
        for at in DISTANCES:
            measured = float(np.interp(-at, -distance, force))
            rows.append([name, f"{at:g}", f"{derjaguin(at, radius, angle):.4f}", f"{measured:.4f}",
                         recipe.deviation(measured, derjaguin(at, radius, angle))])
        axes.plot(distance, force * np.sin(np.radians(angle)) / radius, "o", markersize=3, label=name)
    curve = np.linspace(0.235, 3, 400)
    axes.plot(curve, 2 * np.pi * energy(curve), "k-", linewidth=1, label="Derjaguin")
    axes.set(xlabel="distance [nm]", ylabel="force x sin(angle)/R [2 N/m]", xlim=(0.2, 3))
    axes.legend(fontsize=7)
    recipe.table(["case", "distance [nm]", "Derjaguin [2 nN]", "Ixos", "difference"], rows)
    recipe.save(picture, "crossed-cylinders")


if __name__ == "__main__":
    main()
