#!/usr/bin/python3
"""Draws the error of the force over the time to solution, from the tables "Elements: error over time" and "Elements: the
spatula" of docs/results.md: one panel for the strip and one for the spatula, one colour for each kind of cell.

usage: error_over_time.py [RESULTS] [--output FILE]     (default: docs/results.md, docs/images/elements-time.png)

A point is a run of a table. Lines show the least error that a kind of cell reaches within a time.
"""
import argparse
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "drivers/plot"))
import style  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402
from style import plt  # noqa: E402

KINDS = {"linear, Q1C1": "linear, Q1C1", "linear": "linear, enriched sides", "Enhanced": "Enhanced, enriched sides",
         "quadratic": "quadratic"}
PANELS = {"Elements: error over time": ("strip", "time [s]", "time, s"),
          "Elements: the spatula": ("spatula", "processor time [s]", "processor time, s")}


def table(text, heading):
    """Rows of the first table with a column "cells" below a heading, as dictionaries."""
    lines = iter(text[text.index(f"### {heading}\n"):].splitlines())
    names = next(line for line in lines if line.startswith("|") and "| cells |" in line)
    names = [name.strip() for name in names.strip("|").split("|")]
    next(lines)
    for line in lines:
        if not line.startswith("|"):
            return
        yield dict(zip(names, (cell.strip() for cell in line.strip("|").split("|"))))


def runs(text, heading, cost):
    """Lists of (time, error) by kind of cell."""
    result = {}
    for row in table(text, heading):
        kind = next(name for start, name in KINDS.items() if row["cells"].startswith(start))
        result.setdefault(kind, set()).add((float(row[cost]), float(row["error of the force"])))
    return {kind: sorted(points) for kind, points in result.items()}


def draw(axes, points, kinds):
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
    parser.add_argument("results", nargs="?", type=pathlib.Path, default=ROOT / "docs/results.md")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "docs/images/elements-time.png")
    arguments = parser.parse_args()
    text = arguments.results.read_text(encoding="utf-8")
    style.use_style()
    figure, all_axes = plt.subplots(1, len(PANELS), figsize=(7.6, 3.1), constrained_layout=True)
    kinds = {}
    for axes, (heading, (title, label, cost)) in zip(all_axes, PANELS.items()):
        draw(axes, runs(text, heading, cost), kinds)
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
