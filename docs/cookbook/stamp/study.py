#!/usr/bin/python3
"""Runs xml/stamp.xml: the stamp alone at several speeds, stamp and chip on two walls, and the speed that decides.
Prints the tables of stamp.md and draws stamp.png.

    docs/cookbook/stamp/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as formulas  # noqa: E402
from exodus import Fields  # noqa: E402 (of drivers/plot, which recipe makes known)

ALONE = 0.001, 0.01, 0.1, 1.0, 10.0  # speeds [nm/us]
WALLS = 80.0, 60.0  # Gamma W of the donor and of the receiver
SPEEDS = 0.001, 0.02, 1.0
DECIDING = 0.07, 0.1, 0.14  # on the receiver
RATE = "Histories/Lift/Rate Ramp/Rate"


def alone(speed):
    """Returns the settings of a stamp that is lifted off a chip which is held."""
    return {**recipe.QUIET, RATE: speed, "Boundary Conditions/Held/Node Set": "chip_bottom",
            "Interactions/Wall/Factor": "0"}


def on_a_wall(gamma, speed):
    """Returns the settings of stamp and chip on a wall."""
    return {"Output/Checkpoint/Keep": 0, RATE: speed, "Interactions/Wall/Gamma W": gamma}


def finer():
    """Returns the settings of twice the columns."""
    return {f"Mesh/Parts/{part}/{entry}": value for part, columns, rows, lengths in
            (("chip", 80, 10, [40.0, 20.0]), ("stamp", 152, 25, [76.0, 25.0]))
            for entry, value in (("Box/Divisions", [columns, rows]), ("Box/Lengths", lengths))}


def largest_force(run):
    """Returns the largest force on the stamp before a bond opens, of both halves of the section."""
    bonds = [run[f"contact_measure_{name}"] for name in ("Stamp", "Wall")]
    closed = np.logical_and.reduce([bond > 0 for bond in bonds if bond[0] > 0])
    return 2 * run["reaction_stamp_top_y"][:np.argmin(closed)].max()


def outcome(run):
    """Returns which bond has opened at the end of a run."""
    bonds = {"picked up": run["contact_measure_Wall"][-1], "printed": run["contact_measure_Stamp"][-1]}
    open_bonds = [name for name, width in bonds.items() if width == 0]
    if len(open_bonds) != 1:
        raise RuntimeError(f"{run.folder}: {len(open_bonds)} bonds are open")
    return open_bonds[0]


def known():
    """Returns speeds and forces of the stamp alone, of reference.csv."""
    rows = recipe.reference("stamp")
    return np.array([row["speed"] for row in rows]), np.array([row["force"] for row in rows])


def expected(gamma, speed):
    """Returns the outcome by the forces of both bonds alone."""
    speeds, forces = known()
    stamp = np.interp(np.log(speed), np.log(speeds), forces)
    return "picked up" if stamp > formulas.wall(gamma) else "printed"


def deciding(gamma):
    """Returns the speed at which both bonds alone have one force."""
    speeds, forces = known()
    return float(np.exp(np.interp(formulas.wall(gamma), forces, np.log(speeds))))


def stamps(folder):
    """Runs the stamp alone and prints its table. Returns speeds and forces."""
    rows, points = [], []
    for speed in ALONE:
        run = recipe.run("stamp", alone(speed), folder / f"alone-{speed:g}")
        largest, reference = largest_force(run), float(np.interp(np.log(speed), np.log(known()[0]), known()[1]))
        fine = ""
        if speed == 0.01:
            fine = f"{largest_force(recipe.run('stamp', {**alone(speed), **finer()}, folder / 'finer')):.4f}"
        points.append((speed, largest))
        rows.append([f"{speed:g}", f"{reference:.4f}", f"{largest:.4f}", recipe.deviation(largest, reference), fine,
                     f"{run.energy_error().max():.0e}"])
    recipe.table(["speed [nm/us]", "reference", "Ixos", "difference", "twice the columns", "energy error"], rows)
    return points


def walls(folder):
    """Runs stamp and chip on both walls and prints their table. Returns the runs by wall and speed."""
    rows, runs = [], {}
    for gamma, name in zip(WALLS, ("donor", "receiver")):
        for speed in SPEEDS + (DECIDING if name == "receiver" else ()):
            run = runs[gamma, speed] = recipe.run("stamp", on_a_wall(gamma, speed), folder / f"{name}-{speed:g}")
            rows.append([name, f"{formulas.WORK * formulas.DEFAULT / gamma:.5f}", f"{formulas.wall(gamma):.4f}",
                         f"{deciding(gamma):.3g}", f"{speed:g}", f"{largest_force(run):.4f}", expected(gamma, speed),
                         outcome(run)])
    print()
    recipe.table(["wall", "its work of adhesion", "its force, 2 a s", "speed that decides, reference",
                  "speed [nm/us]", "largest force", "expected", "outcome"], rows)
    return runs


def section(axes, run, title):
    """Draws the outlines of chip and stamp at the end of a run, vertical displacements five times as large."""
    fields = Fields(run.folder)
    moved = fields.coordinates + fields.displacement(-1)
    scale = 5.0
    for color, low, high in ((recipe.style.COLORS[1], 0.2, 20.4), (recipe.style.COLORS[0], 20.5, 1e3)):
        nodes = (fields.coordinates[:, 1] > low - 0.01) & (fields.coordinates[:, 1] < high)
        cells = [cell for cell in fields.cells if nodes[cell].all()]
        for cell in cells:
            ring = [*cell[:4], cell[0]]
            places = moved[ring].copy()
            places[:, 1] = fields.coordinates[ring, 1] + scale * (moved[ring, 1] - fields.coordinates[ring, 1])
            for sign in (1, -1):
                axes.plot(sign * places[:, 0], places[:, 1], color=color, linewidth=0.3)
    axes.axhline(0, color=recipe.style.INK, linewidth=2)
    axes.set(xlim=(-55, 55), ylim=(-3, 55), aspect="equal", title=title, xlabel="x [nm]")


def draw(points, runs):
    """Draws the forces of both bonds over the speed, and the sections after a fast and a slow lift."""
    picture, (left, middle, right) = recipe.figure(3, 9.0, 2.9)
    speeds, forces = known()
    left.plot(speeds, forces, "--", color=recipe.style.INK, label="stamp, reference")
    left.plot(*zip(*points), "o", markersize=4, color=recipe.style.COLORS[0], label="stamp, Ixos")
    for gamma, name, line in zip(WALLS, ("donor", "receiver"), (":", "-.")):
        left.axhline(formulas.wall(gamma), color=recipe.style.COLORS[1], linestyle=line, label=name)
    left.set(xscale="log", xlabel="speed [nm/µs]", ylabel="force per length [2 N/m]", ylim=(0.9, 1.9))
    left.legend(fontsize=7)
    for axes, speed, title in ((middle, 1.0, "receiver, 1 nm/µs"), (right, 0.02, "receiver, 0.02 nm/µs")):
        section(axes, runs[WALLS[1], speed], title)
    recipe.save(picture, "stamp")


def main():
    folder = recipe.arguments(__doc__).results
    points = stamps(folder)
    draw(points, walls(folder))


if __name__ == "__main__":
    main()
