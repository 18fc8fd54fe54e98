#!/usr/bin/python3
"""Draws the error of the force over the number of unknowns, from the data of the table elements-refinement: a panel for
each scene, meshes that are equally fine everywhere beside those that are finer at the contact.

usage: error_over_unknowns.py [DATA] [--output FILE]     (default: docs/results/data, docs/images/elements-refinement.png)
"""
import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "drivers/plot"))
import style  # noqa: E402
from style import plt  # noqa: E402

TITLES = {"strip": "strip", "jkr": "JKR sphere, graded by a map", "jkr of equal cells": "JKR sphere of equal cells"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", nargs="?", type=pathlib.Path, default=ROOT / "docs/results/data")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "docs/images/elements-refinement.png")
    arguments = parser.parse_args()
    style.use_style()
    rows = json.loads((arguments.data / "elements-refinement.json").read_text(encoding="utf-8"))["rows"]
    figure, all_axes = plt.subplots(1, len(TITLES), figsize=(10.5, 3.1), constrained_layout=True)
    for axes, (scene, title) in zip(all_axes, TITLES.items()):
        for number, (label, levels) in enumerate((("uniform", False), ("finer at the contact", True))):
            points = sorted((row["dofs"], row["error"]) for row in rows
                            if row["scene"] == scene and ("level" in row["mesh"]) == levels)
            axes.loglog(*zip(*points), color=style.COLORS[number], marker="os"[number], markersize=5, linewidth=1.1,
                        label=label)
        axes.set_title(title)
        axes.set_xlabel("degrees of freedom")
        axes.set_ylabel("error of the force")
    all_axes[0].legend()
    figure.savefig(arguments.output)


if __name__ == "__main__":
    main()
