#!/usr/bin/python3
"""Runs xml/mems-beam.xml at several voltages, as a cantilever and as a bridge, and compares the pull-in.

    docs/cookbook/mems-beam/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as beam_theory  # noqa: E402

INSULATION = 0.05  # [um]: the electric gap is the gap and this
LAYER = 0.2  # gap below which the beam touches the layer [um]
BRIDGE = {f"Boundary Conditions/{name}/{key}": value for name, key, value in (
    ("Far Clamp", "Node Set", "right"), ("Far Clamp", "Components", "x"), ("Far Descent", "Node Set", "right"),
    ("Far Descent", "Components", "y"), ("Far Descent", "History", "Down"))}


def settings(row, step):
    """Returns the settings of a run from 30 per cent above the gap of its pull-in to 10 per cent below."""
    start = 1.3 * row["pull_in_gap"]
    far = 100 if row["beam"] == "bridge" else 200  # place of the largest deflection
    return {"Interactions/Electrode/Electrostatic/Voltage": row["voltage"], "Mesh/Box/Lower": [0.0, start],
            "Output/Probes/tip/Point": [far, start], recipe.STEPS + "Time Step": step,
            recipe.STEPS + "Final Time": round(0.4 * row["pull_in_gap"], 2), **recipe.QUIET,
            **(BRIDGE if row["beam"] == "bridge" else {})}


def pull_in(run, start):
    """Returns the electric gap of the undeflected beam between the last step before pull-in and the first after it
    [um], and the deflection over the gap before it."""
    first = int(np.argmax(run["min_gap"] < LAYER))
    if first == 0:
        raise RuntimeError(f"{run.folder}: no pull-in")
    last = first - 1
    gap = start + INSULATION - 0.5 * (run["time"][last] + run["time"][first])
    return gap, -(run["tip_uy"][last] + run["time"][last]) / gap


def measure(row, step, folder):
    """Runs one row of reference.csv. Returns the run, the gap at pull-in and the deflection there."""
    chosen = settings(row, step)
    run = recipe.run("mems-beam", chosen, folder / f"{row['beam']}-{row['voltage']:g}")
    return run, *pull_in(run, chosen["Mesh/Box/Lower"][1])


def draw(run, start, gap):
    """Draws deflection over voltage, and the gap below the tip over the height of the clamp."""
    picture, (left, right) = recipe.figure(2)
    deflections = np.linspace(0.01, 0.95, 60)
    loads = np.array([beam_theory.load("cantilever", value) for value in deflections])
    top = loads.argmax()
    for part, line, label in ((slice(top + 1), "-", "beam equation"), (slice(top, None), ":", "unstable")):
        left.plot(np.sqrt(loads[part] / loads[top]), deflections[part], line, color=recipe.style.INK, label=label)
    height = start + INSULATION - run["time"]
    stable = run["min_gap"] > LAYER
    steps = np.flatnonzero(stable)[1::40].tolist() + [np.flatnonzero(stable)[-1]]
    left.plot((gap / height[steps])**1.5, -(run["tip_uy"] + run["time"])[steps] / height[steps], "o", markersize=3.5,
              color=recipe.style.COLORS[0], label="Ixos")
    left.set(xlabel="voltage / pull-in voltage", ylabel="deflection of the tip / gap", xlim=(0, 1.1), ylim=(0, 1))
    left.legend()
    right.plot(start - run["time"][1:], run["min_gap"][1:], color=recipe.style.COLORS[0])
    right.set(xlabel="height of the clamp [µm]", ylabel="gap below the tip [µm]", ylim=(0, None))
    right.invert_xaxis()
    recipe.save(picture, "mems-beam")


def main():
    folder = recipe.arguments(__doc__).results
    rows, drawn = [], None
    for row in recipe.reference("mems-beam"):
        run, gap, deflection = measure(row, 0.001, folder)
        rows.append([row["beam"], f"{row['voltage']:g}", f"{row['pull_in_gap']:.4f}", f"{gap:.4f}",
                     recipe.deviation(gap, row["pull_in_gap"]), f"{row['deflection']:.3f}", f"{deflection:.3f}"])
        if row["beam"] == "cantilever" and row["voltage"] == 20:
            drawn = run, 1.3 * row["pull_in_gap"], gap
    recipe.table(["beam", "voltage [V]", "gap at pull-in, beam equation [µm]", "Ixos [µm]", "difference",
                  "deflection / gap, beam equation", "Ixos, last step before"], rows)
    draw(*drawn)


if __name__ == "__main__":
    main()
