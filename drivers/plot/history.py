#!/usr/bin/python3
"""Draws the history of one run, or compares those of several: energies, energy error, least gap, contact force,
reactions and Newton iterations over one time axis. What a run did not write is left out."""
import numpy as np
from matplotlib.ticker import LogLocator, MaxNLocator

import style
from results import ResultsError, Run, labels
from style import plt

PIECES = 60  # of the time axis, for means

EPILOG = """examples:
  history.py ball.results                            -> ball.results/history.png
  history.py a.results b.results --output compared   -> compared.png
  history.py a.results b.results --relative initial  energy errors over the initial energy's size
  history.py a.results b.results --relative 0.155    energy errors over a scale of your own [E0 L0^2; E0 L0^3 in 3D]

Fast oscillations are drawn faint, and strong their mean over each 1/60 of the time; --time shows a part in full.
Reactions of Gautam-Sauer Composite, Average Vector Field, Energy-Momentum and Midpoint are means over the step and stand
at its middle. Where runs are compared, a cross marks where one diverged, and linear axes fit the others."""


def pieces_of(values):
    """Indices of at most PIECES equal pieces of a history."""
    return np.array_split(np.arange(len(values)), min(len(values), PIECES))


def is_fast(values):
    """Whether a history swings through its range too often to be followed."""
    span = np.nanmax(values) - np.nanmin(values)
    return span > 0 and np.nansum(np.abs(np.diff(values))) > 2 * PIECES * span


def draw_line(axes, run, values, color, label=None, fast=False):
    """A history, with a cross where it diverged; a fast one faint, under its piecewise mean."""
    axes.plot(run["time"], values, color=color, label=None if fast else label,
              **({"linewidth": 0.4, "alpha": 0.4} if fast else {}))
    if fast:
        pieces = pieces_of(values)
        axes.plot([run["time"][piece].mean() for piece in pieces], [values[piece].mean() for piece in pieces],
                  color=color, linewidth=1.2, label=label)
    if run.diverged:
        axes.plot(run["time"][-1], values[-1], "x", color=color, markersize=5)


def draw_column(axes, runs, column):
    """One column of every run that has it."""
    runs = [run for run in runs if run.has(column)]
    fast = axes.get_yscale() == "linear" and any(is_fast(run[column]) for run in runs)
    for run in runs:
        draw_line(axes, run, run[column], run.color, fast=fast)
    fit(axes, runs, column)
    if axes.get_yscale() == "log" and axes.get_ylim()[1] < 100 * axes.get_ylim()[0]:
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter("")


def fit(axes, runs, column):
    """Limits of a linear axis by the runs that did not diverge: one that did would flatten all others."""
    steady = [run[column] for run in runs if not run.diverged]
    if steady and any(run.diverged for run in runs) and axes.get_yscale() == "linear":
        low, high = min(np.nanmin(values) for values in steady), max(np.nanmax(values) for values in steady)
        axes.set_ylim(low - 0.06 * (high - low or 1), high + 0.06 * (high - low or 1))


def draw_energies(axes, run):
    """All energies of one run."""
    for kind, color in zip(("kinetic", "elastic", "contact", "total"), style.COLORS[:3] + ["#000000"]):
        if run.has(f"{kind}_energy"):
            values = run[f"{kind}_energy"]
            draw_line(axes, run, values, color, kind, is_fast(values))
    key(axes)


def draw_errors(axes, runs, relative):
    """Energy errors; zeros have no place on the log axis."""
    for run in runs:
        if not run.has("total_energy"):
            continue
        scale = abs(run.initial_energy) if relative == "initial" else relative or 1.0
        if not scale > 0:
            raise ResultsError(f"{run.folder}: the initial energy is zero, no error can be relative to it")
        error = run.energy_error() / scale
        draw_line(axes, run, np.where(error > 0, error, np.nan), run.color)


def draw_reactions(axes, runs):
    """Reactions: a colour each for one run; for several a colour each run and a line style each reaction."""
    styles = {}
    for run in runs:
        for name, time, values in run.reactions():
            new = name not in styles
            dashes = styles.setdefault(name, ["-", "--", ":", "-."][len(styles) % 4])
            look = {"color": run.color, "linestyle": dashes} if len(runs) > 1 else {}
            axes.plot(time, values, **look, label=name[len("reaction_"):].replace("_", " ") if new else None)
    key(axes)


def draw_iterations(axes, runs):
    """Newton iterations a step: mean and, shaded, range of each piece."""
    for run in runs:
        if not run.has("newton_iterations") or len(run["step"]) < 2:
            continue
        count = run["newton_iterations"][1:] / np.maximum(np.diff(run["step"]), 1)
        pieces = pieces_of(count)
        time, mean, low, high = ([function(values[piece]) for piece in pieces] for function, values in (
            (np.mean, run["time"][1:]), (np.mean, count), (np.min, count), (np.max, count)))
        axes.plot(time, mean, color=run.color)
        axes.fill_between(time, low, high, color=run.color, alpha=0.13, linewidth=0)
    axes.set_ylim(bottom=0)
    axes.yaxis.set_major_locator(MaxNLocator(4, integer=True))


def key(axes, *entries):
    """A legend above a panel."""
    axes.legend(*entries, ncol=4, loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, handlelength=1.6)


def panels(runs, relative):
    """(height, label, log axis?, function that draws) of each panel that has something to show."""
    dimension = max(run.dimension for run in runs)
    energy, force = style.unit("energy", dimension), style.unit("force", dimension)
    contact = "contact_force_z" if dimension == 3 else "contact_force_y"
    over = {None: energy, "initial": "/ |initial energy|"}.get(relative, f"/ {relative} {energy.strip('[]')}")
    several = len(runs) > 1

    def has(column):
        return any(run.has(column) for run in runs)

    def column(name):
        return lambda axes: draw_column(axes, runs, name)

    table = [
        (not several and has("kinetic_energy"), 1.8, f"energy\n{energy}", False, lambda axes: draw_energies(axes, runs[0])),
        (several and has("total_energy"), 1.2, f"total energy\n{energy}", False, column("total_energy")),
        (several and has("kinetic_energy"), 1.2, f"kinetic energy\n{energy}", False, column("kinetic_energy")),
        (has("total_energy"), 1.2, f"energy error\n{over}", True, lambda axes: draw_errors(axes, runs, relative)),
        (has("min_gap"), 1.0, f"least gap\n{style.unit('length', dimension)}", True, column("min_gap")),
        (has(contact), 1.2, f"contact force {contact[-1]}\n{force}", False, column(contact)),
        (any(run.reactions() for run in runs), 1.2, f"reaction\n{force}", False, lambda axes: draw_reactions(axes, runs)),
        (has("newton_iterations"), 0.8, "Newton\niterations", False, lambda axes: draw_iterations(axes, runs)),
    ]
    return [row[1:] for row in table if row[0]]


def main():
    parser = style.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="a results folder (with history.csv)")
    parser.add_argument("--output", metavar="NAME", help="what to write, without ending (default: FOLDER/history; "
                        "history in the present folder where several are compared)")
    parser.add_argument("--format", type=style.formats, default=["png"], help="png, svg or png,svg (default: png)")
    parser.add_argument("--relative", type=style.scale, metavar="initial|SCALE", help="divide energy errors by this")
    parser.add_argument("--time", type=style.interval, metavar="FROM,TO", help="the part to draw (default: all)")
    arguments = parser.parse_args()

    runs = [Run(folder, arguments.time) for folder in arguments.folders]
    for number, (run, label) in enumerate(zip(runs, labels(runs))):
        run.color, run.label = style.COLORS[number % len(style.COLORS)], label
        run.diverged = len(runs) > 1 and run.summary.get("status") == "diverged"
    rows = panels(runs, arguments.relative)
    if not rows:
        raise ResultsError("these runs wrote no column that could be drawn")
    heights = [row[0] for row in rows]
    figure, grid = plt.subplots(len(rows), 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(7.2, 1.05 * sum(heights) + 0.7), height_ratios=heights)
    for axes, (_, label, log, draw) in zip(grid[:, 0], rows):
        axes.set_yscale("log" if log else "linear")
        draw(axes)
        axes.set_ylabel(label)
    grid[-1, 0].set_xlabel(f"time {style.unit('time', 2)}")
    grid[-1, 0].set_xlim(min(run["time"][0] for run in runs), max(run["time"][-1] for run in runs))
    figure.align_ylabels()
    if len(runs) == 1:
        figure.suptitle(runs[0].label, x=0.01, ha="left", fontsize=10, fontweight="bold")
    else:
        lines = [plt.Line2D([], [], color=run.color, linewidth=1.6) for run in runs]
        key(grid[0, 0], lines, [run.label for run in runs])
    style.save(figure, arguments.output or ("history" if len(runs) > 1 else runs[0].folder / "history"), arguments.format)


if __name__ == "__main__":
    style.run(main)
