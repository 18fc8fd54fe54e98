#!/usr/bin/python3
"""Runs xml/waviness.xml on two meshes. Prints the table of waviness.md and draws waviness.png.

    docs/cookbook/waviness/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402

AMPLITUDE, PERIOD, MODULUS = 3.0, 400.0, 0.507995 / (1 - 0.3 ** 2)  # h, lambda, E*
FLATTENING = np.pi * MODULUS * AMPLITUDE / PERIOD  # p*, the pressure that flattens the waves without adhesion
ALPHA = (2 * recipe.WORK / (np.pi * AMPLITUDE * FLATTENING)) ** 0.5


class Pull:
    """Time, mean pressure over p* and half of the contact width over the period, and both at the pull-off."""

    def __init__(self, settings, folder):
        run = recipe.run("waviness", settings, folder)
        self.time, self.width = run["time"], run["contact_measure"] / PERIOD
        self.pressure = run["contact_force_y"] / (PERIOD / 2) / FLATTENING
        half = len(self.time) // 2
        i = half + int(self.pressure[half:].argmin())
        moment, self.pull_off = recipe.vertex(self.time, self.pressure, i)
        self.pull_off_width = float(np.interp(moment, self.time, self.width))


def pull(cell, folder):
    """Runs the scene with cells of a width, and returns its Pull."""
    return Pull({"Mesh/Box/Divisions": [round(200 / cell), round(32 / cell)], "Output/Checkpoint/Keep": 0}, folder)


def johnson(width):
    """Returns the mean pressure over p* for half of the contact width over the period (Johnson 1995)."""
    return np.sin(np.pi * width) ** 2 - ALPHA * np.sqrt(np.tan(np.pi * width))


def draw(run):
    """Draws the pressure over the contact width."""
    picture, axes = recipe.figure(1, 4.8, 3.2)
    width = np.linspace(1e-4, 0.36, 400)
    axes.plot(width, johnson(width), "k--", label="Johnson")
    half = len(run.time) // 2
    axes.plot(run.width[:half + 1], run.pressure[:half + 1], label="pressed on")
    axes.plot(run.width[half:], run.pressure[half:], label="pulled off")
    axes.set(xlabel="half of the contact width / period [-]", ylabel="mean pressure / $p^*$ [-]")
    axes.legend()
    recipe.save(picture, "waviness")


def main():
    results = recipe.arguments(__doc__).results
    known = {row["quantity"]: row["value"] for row in recipe.reference("waviness")}
    runs = [pull(cell, results / f"{cell:g}") for cell in (2.0, 1.0)]
    print(f"alpha = {ALPHA:.4f}, p* = {FLATTENING:.6f} E0\n")
    recipe.table(["", "Johnson", "cells of 2 nm", "1 nm", "difference (1 nm)"],
                 [["pull-off / p*", f"{known['pull-off']:.4f}", *(f"{run.pull_off:.4f}" for run in runs),
                   recipe.deviation(runs[-1].pull_off, known["pull-off"])],
                  ["half width there / period", f"{known['half width']:.4f}",
                   *(f"{run.pull_off_width:.4f}" for run in runs),
                   recipe.deviation(runs[-1].pull_off_width, known["half width"])]])
    draw(runs[-1])


if __name__ == "__main__":
    main()
