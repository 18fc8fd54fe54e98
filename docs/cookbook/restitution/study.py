#!/usr/bin/python3
"""Runs xml/restitution.xml over speeds. Prints the tables of restitution.md and draws restitution.png.

    docs/cookbook/restitution/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402

RADIUS, STIFFNESS, MASS = 1000.0, 1 / 0.91, 2094.4  # R, E* and the mass of the ball
BRANCH = 0.3  # shear modulus of the Maxwell branch
GAP, CLEAR = 1.5, 0.02  # at the start, with adhesion and without
COARSE, FINE = 10, 15  # how much smaller the map makes the cells at the lowest point


def duration(speed):
    """Returns the duration of Hertz's contact (Johnson 1985, chapter 11)."""
    return 2.868 * (MASS ** 2 / (STIFFNESS ** 2 * RADIUS * speed)) ** 0.2


def disk_map(factor, gap):
    """Returns the map that draws the nodes to the lowest point, for a gap below it."""
    a = f"{factor - 1}/{factor + 1}"
    below = f"((1 - {a}*y)^2 + ({a}*x)^2)"
    return {"Mesh/Map/X": f"1000*(1 - ({a})^2)*x/{below}",
            "Mesh/Map/Y": f"{1000 + gap!r} + 1000*((y - {a})*(1 - {a}*y) - {a}*x^2)/{below}",
            "Mesh/Disk/Core Divisions": 4 * factor, "Mesh/Disk/Rings": 6 * factor // 5}


def viscoelastic(time):
    """Returns the settings of a Maxwell branch with a relaxation time; none for 0."""
    branches = "Materials/Ball/Maxwell Branches/"
    return {branches + "Relaxation Times": [time], branches + "Moduli": [BRANCH]} if time else {}


def attraction(gap):
    """Returns the energy of the wall's force on the ball, as a paraboloid, at a gap."""
    ratio = recipe.EQUILIBRIUM_GAP / gap
    return 2 * np.pi * RADIUS * recipe.WORK / 3 * gap * (ratio ** 8 / 7 - 4 * ratio ** 2)


class Impact:
    """Restitution, shares of the energy, and duration of the contact of a run.

    The energy of translation counts the energy of the wall's force: it is that of the ball far from the wall. The
    restitution is the root of its ratio after and before the contact, and 0 if the ball does not get away."""

    def __init__(self, settings, folder):
        run = recipe.run("restitution", {**settings, **recipe.QUIET}, folder)
        momentum = run["linear_momentum_y"]
        mass = momentum[0] ** 2 / (2 * run["kinetic_energy"][0])
        energy = momentum ** 2 / (2 * mass) + run["contact_energy"]
        # The surface vibrates in the field of the wall: the mean of the last steps.
        ratio = energy[-10:].mean() / energy[0]
        self.restitution = max(ratio, 0.0) ** 0.5
        self.time, self.force = run["time"][1:], np.diff(momentum) / np.diff(run["time"])
        touching = np.nonzero(np.abs(run["contact_force_y"]) > 1e-3 * np.abs(run["contact_force_y"]).max())[0]
        self.contact_time = run["time"][touching[-1]] - run["time"][touching[0]]
        self.lost, self.before = energy[0] - energy[-10:].mean(), energy[0]
        self.dissipated = run["dissipated_energy"][-1] / energy[0]
        self.error = run.summary["max_energy_error"] / energy[0]


def impact(speed, folder, time=0.0, steps=200):
    """Returns the Impact of a ball without adhesion, its contact resolved by a number of steps."""
    wall = "Interactions/Wall/"
    step = duration(speed) / steps
    return Impact({"Initial Conditions/Velocity": [0.0, -speed], recipe.STEPS + "Time Step": step,
                   recipe.STEPS + "Final Time": 1.3 * steps * step, wall + "Law": "Penalty",
                   wall + "Penalty/Stiffness": 10.0, wall + "Penalty/Gap": 0.01, **disk_map(COARSE, CLEAR),
                   **viscoelastic(time)}, folder)


def adhesive_impact(speed, folder, time=0.0, factor=COARSE):
    """Returns the Impact of a ball with adhesion. The speed is that far from the wall."""
    start = (speed ** 2 - 2 * attraction(GAP) / MASS) ** 0.5
    step = duration(speed) / 200
    return Impact({"Initial Conditions/Velocity": [0.0, -start], recipe.STEPS + "Time Step": step,
                   recipe.STEPS + "Final Time": round((1.5 * duration(speed) + 1.5 / speed) / step) * step,
                   **disk_map(factor, GAP), **viscoelastic(time)}, folder)


def waves(known, results):
    rows = []
    for row in known:
        run = impact(row["speed"], results / f"waves-{row['speed']:g}")
        rows.append([f"{row['speed']:g}", f"{1 - row['restitution'] ** 2:.2e}", f"{run.lost / run.before:.2e}",
                     f"{row['contact_time']:.2f}", f"{run.contact_time:.2f}",
                     recipe.deviation(run.contact_time, row["contact_time"]), f"{run.error:.0e}"])
    recipe.table(["speed [nm/ns]", "share of waves, reference", "measured", "contact, Hertz [ns]", "measured",
                  "difference", "energy error"], rows)


def viscosity(known, results):
    rows, runs = [], {}
    for row in known:
        run = impact(row["speed"], results / f"viscosity-{row['speed']:g}-{row['relaxation_time']:g}",
                     row["relaxation_time"])
        runs[row["speed"], row["relaxation_time"]] = run
        rows.append([f"{row['speed']:g}", f"{row['relaxation_time']:g}", f"{row['restitution']:.4f}",
                     f"{run.restitution:.4f}", recipe.deviation(run.restitution, row["restitution"]),
                     f"{row['contact_time']:.2f}", f"{run.contact_time:.2f}", f"{run.dissipated:.4f}"])
    recipe.table(["speed [nm/ns]", "relaxation time [ns]", "restitution, reference", "measured", "difference",
                  "contact, reference [ns]", "measured", "share dissipated"], rows)
    return runs


def adhesion(known, results):
    rows, points = [], []
    for speed in 0.11, 0.13, 0.2, 0.4:
        run = adhesive_impact(speed, results / f"adhesion-{speed:g}")
        fine = f"{adhesive_impact(speed, results / f'fine-{speed:g}', factor=FINE).restitution:.3f}" \
            if speed in (0.2, 0.4) else ""
        points.append((speed, run.restitution))
        expected = (max(1 - (known / speed) ** 2, 0)) ** 0.5
        rows.append([f"{speed:g}", f"{expected:.3f}", f"{run.restitution:.3f}", fine, f"{run.lost:.1f}",
                     f"{run.error:.0e}"])
    recipe.table(["speed [nm/ns]", "restitution, reference", "measured", "finer cells", "energy lost [E0 L0^3]",
                  "energy error"], rows)
    return points


def both(results):
    rows, points = [], []
    for speed in 0.4, 0.6, 1.0:
        run = adhesive_impact(speed, results / f"both-{speed:g}", 3.0)
        points.append((speed, run.restitution))
        rows.append([f"{speed:g}", f"{run.restitution:.3f}", f"{run.dissipated:.3f}", f"{run.error:.0e}"])
    recipe.table(["speed [nm/ns]", "restitution", "share dissipated", "energy error"], rows)
    return points


def draw(pulses, sticking, jkr, elastic, damped):
    """Draws the force of the impacts at 1 nm/ns, and the restitution with adhesion over the speed."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.0)
    for (speed, time), run in pulses.items():
        if speed == 1.0:
            left.plot(run.time, run.force, label=f"relaxation time {time:g} ns")
    left.set(xlabel="time [ns]", ylabel="force [$E_0 L_0^2$]", xlim=(0, 16.5))
    left.legend(fontsize=7)
    speed = np.geomspace(0.1, 1.2, 300)
    for value, line, name in ((sticking, "k--", "half-space, slow"), (jkr, "k:", "JKR, slow")):
        right.plot(speed, np.sqrt(np.maximum(1 - (value / speed) ** 2, 0)), line, label=name)
    right.plot(*zip(*elastic), "o", markersize=5, label="elastic")
    right.plot(*zip(*damped), "s", markersize=5, label="viscoelastic, 3 ns")
    right.set(xscale="log", xlabel="speed [nm/ns]", ylabel="restitution [-]", ylim=(-0.03, 1.03))
    right.set_xticks([0.1, 0.2, 0.4, 1.0], ["0.1", "0.2", "0.4", "1"])
    right.minorticks_off()
    right.legend(fontsize=7, loc="center right")
    recipe.save(picture, "restitution")


def main():
    results = recipe.arguments(__doc__).results
    known = {}
    for row in recipe.reference("restitution"):
        known.setdefault(row["series"], []).append(row)
    sticking, jkr = (known[name][0]["speed"] for name in ("adhesion", "adhesion JKR"))
    print("Without adhesion, elastic\n")
    waves(known["waves"], results)
    print("\nWithout adhesion, viscoelastic\n")
    pulses = viscosity(known["viscosity"], results)
    print(f"\nWith adhesion, elastic: sticks below {sticking:.4f} by the reference, {jkr:.4f} by JKR\n")
    elastic = adhesion(sticking, results)
    print("\nWith adhesion, viscoelastic\n")
    draw(pulses, sticking, jkr, elastic, both(results))


if __name__ == "__main__":
    main()
