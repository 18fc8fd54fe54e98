#!/usr/bin/python3
"""Draws the error of the force over the time to solution, from the data of two tables of docs/results/elements.md: one
panel for the strip and one for the spatula, one colour for each kind of cell.

usage: error_over_time.py [DATA] [--output FILE]     (default: docs/results/data, docs/images/elements-time.png)

A point is a run of a table. Lines show the least error that a kind of cell reaches within a time.
"""
import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "drivers/plot"))
import style  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402
from style import plt  # noqa: E402

KINDS = {"linear, Q1C1": "linear, Q1C1", "linear": "linear, enriched sides", "Enhanced": "Enhanced, enriched sides",
         "quadratic": "quadratic"}
# By table: title, label of the time, and the keys of time and error of each point of a row.
PANELS = {"elements-strip": ("strip", "time [s]", [(f"{scheme} seconds", f"{scheme} error")
                                                   for scheme in ("Newmark", "Static")]),
          "elements-spatula": ("spatula", "processor time [s]", [("seconds", "error")])}


def runs(file, keys):
    """Returns lists of (time, error) by kind of cell."""
    result = {}
    for row in json.loads(file.read_text(encoding="utf-8"))["rows"]:
        kind = next(name for start, name in KINDS.items() if row["cells"].startswith(start))
        result.setdefault(kind, set()).update((row[time], row[error]) for time, error in keys)
    return {kind: sorted(points) for kind, points in result.items()}


def draw(axes, points, kinds):
    """Draws the points of a panel. Adds a line for the legend to `kinds`."""
    for number, kind in enumerate(KINDS.values()):
        if kind not in points:
            continue
        look = {"color": style.COLORS[number], "marker": "os^D"[number], "linestyle": "none", "markersize": 5}
        axes.plot(*zip(*points[kind]), **look)
        times, errors, least = [], [], float("inf")
        for time, error in points[kind]:
            if error < least:
                times, errors, least = times + [time], errors + [error], error
        axes.plot(times, errors, color=style.COLORS[number], drawstyle="steps-post", linewidth=1.1)
        kinds.setdefault(kind, plt.Line2D([], [], linewidth=1.1, **{**look, "linestyle": "-"}))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", nargs="?", type=pathlib.Path, default=ROOT / "docs/results/data")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "docs/images/elements-time.png")
    arguments = parser.parse_args()
    style.use_style()
    figure, all_axes = plt.subplots(1, len(PANELS), figsize=(7.6, 3.1), constrained_layout=True)
    kinds = {}
    for axes, (table, (title, label, keys)) in zip(all_axes, PANELS.items()):
        draw(axes, runs(arguments.data / f"{table}.json", keys), kinds)
        axes.set(xscale="log", yscale="log", title=title, xlabel=label)
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_formatter(NullFormatter())
    all_axes[0].set_ylabel("relative error of the force")
    names = [kind for kind in KINDS.values() if kind in kinds]
    figure.legend([kinds[kind] for kind in names], names, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=len(names))
    figure.savefig(arguments.output, bbox_inches="tight")


if __name__ == "__main__":
    main()
