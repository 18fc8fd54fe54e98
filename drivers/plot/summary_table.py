#!/usr/bin/env python3
"""Prints a Markdown table of results folders: summary_table.py FOLDER...

The energy error is given absolutely, relative to the initial energy, and relative to ENERGY_SCALE
(--scale; for the ball the work of adhesion times the diameter, 0.1549567 E0 L0^2)."""
import argparse
import csv
import json
import pathlib


def row(folder, scale):
    summary = json.loads((folder / "summary.json").read_text())
    with open(folder / "history.csv", newline="") as file:
        initial = float(next(csv.DictReader(file))["total_energy"])
    error = summary["max_energy_error"]
    steps = max(summary["steps"], 1)
    return [
        summary["scheme"], summary["status"], f"{summary['end_time']:.4g}", f"{error:.3g}",
        f"{error / abs(initial):.3g}", f"{error / scale:.3g}", f"{summary['newton_iterations'] / steps:.2f}",
        f"{1e3 * summary['wall_seconds'] / summary['newton_iterations']:.4f}", f"{summary['wall_seconds']:.2f}",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--scale", type=float, default=0.1549567)
    arguments = parser.parse_args()
    header = ["scheme", "status", "end time", "max energy error", "to initial energy", "to energy scale",
              "Newton iterations a step", "ms an iteration", "seconds"]
    for cells in [header, ["---"] * len(header)] + [row(folder, arguments.scale) for folder in arguments.folders]:
        print("| " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
