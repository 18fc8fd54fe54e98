#!/usr/bin/python3
"""Draws the error of the force over the number of unknowns and over the time, from the data of the tables elements-front
and elements-sphere: meshes that are equally fine everywhere beside those that follow the front.

usage: error_of_following.py [DATA] [--output FILE]     (default: docs/results/data, docs/images/elements-front.png)
"""
import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "drivers/plot"))
import style  # noqa: E402
from style import plt  # noqa: E402

# Table, key of the horizontal axis, title and label.
PANELS = (("elements-front", "mean", "strip", "mean degrees of freedom"), ("elements-front", "seconds", "strip", "time, s"),
          ("elements-sphere", "mean", "sphere in space", "mean degrees of freedom"),
          ("elements-sphere", "seconds", "sphere in space", "time, s"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", nargs="?", type=pathlib.Path, default=ROOT / "docs/results/data")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "docs/images/elements-front.png")
    arguments = parser.parse_args()
    style.use_style()
    figure, all_axes = plt.subplots(1, len(PANELS), figsize=(12.5, 3.0), constrained_layout=True)
    for axes, (table, key, title, label) in zip(all_axes, PANELS):
        path = arguments.data / f"{table}.json"
        rows = json.loads(path.read_text(encoding="utf-8"))["rows"] if path.exists() else []
        for number, (name, follows) in enumerate((("uniform", False), ("follows the front", True))):
            points = sorted((row[key], row["error"]) for row in rows
                            if row["error"] > 0 and ("level" in row["mesh"]) == follows)
            if points:
                axes.loglog(*zip(*points), color=style.COLORS[number], marker="os"[number], markersize=5,
                            linewidth=0 if follows else 1.1, label=name)
        axes.set_title(title)
        axes.set_xlabel(label)
        axes.set_ylabel("error of the force")
    all_axes[0].legend()
    figure.savefig(arguments.output)


if __name__ == "__main__":
    main()
