"""Curves of histories on matplotlib's axes; runs carry their color and whether they diverged beside others."""
import numpy as np
from matplotlib.ticker import LogLocator, MaxNLocator

import style
from results import ResultsError, labels

PIECES = 60  # of the time axis, for means


def dress(runs):
    """Gives each run its colour, its label, and whether it diverged beside others."""
    for number, (run, label) in enumerate(zip(runs, labels(runs))):
        run.color, run.label = style.COLORS[number % len(style.COLORS)], label
        run.diverged = len(runs) > 1 and run.summary.get("status") == "diverged"


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
    if run.diverged and run.whole:
        axes.plot(run["time"][-1], values[-1], "x", color=color, markersize=5)


def draw_column(axes, runs, column):
    """One column of every run that has it."""
    runs = [run for run in runs if run.has(column)]
    fast = axes.get_yscale() == "linear" and any(is_fast(run[column]) for run in runs)
    for run in runs:
        draw_line(axes, run, run[column], run.color, fast=fast)
    fit(axes, [(run, run[column]) for run in runs])
    if axes.get_yscale() == "log" and axes.get_ylim()[1] < 100 * axes.get_ylim()[0]:
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter("")


def fit(axes, histories):
    """Limits of a linear axis by the runs that did not diverge: one that did would flatten all others.

    histories: pairs of a run and what it shows."""
    steady = [values for run, values in histories if not run.diverged] or [values for _, values in histories]
    if steady and axes.get_yscale() == "linear":
        low, high = min(np.nanmin(values) for values in steady), max(np.nanmax(values) for values in steady)
        axes.set_ylim(low - 0.06 * (high - low or 1), high + 0.06 * (high - low or 1))


def draw_total(axes, runs):
    """Total energies, on a scale on which round-off stays invisible: a tenth of the kinetic energy's range or more."""
    draw_column(axes, runs, "total_energy")
    spans = [np.nanmax(run["kinetic_energy"]) for run in runs if run.has("kinetic_energy") and not run.diverged]
    low, high = axes.get_ylim()
    missing = 0.1 * max(spans, default=0) - (high - low)
    if missing > 0:
        axes.set_ylim(low - missing / 2, high + missing / 2)


def draw_energies(axes, run):
    """All energies of one run."""
    for kind, color in zip(("kinetic", "elastic", "contact", "total"), style.COLORS[:3] + ["#000000"]):
        if run.has(f"{kind}_energy"):
            values = run[f"{kind}_energy"]
            draw_line(axes, run, values, color, kind, is_fast(values))
    if "released_energy" in run.columns and (run["released_energy"] > 0).any():
        axes.plot(run["time"], run["released_energy"], color=style.COLORS[3], linestyle="--", label="released by jumps")
    key(axes)


def draw_errors(axes, runs, relative):
    """Energy errors; zeros have no place on the log axis."""
    for run in runs:
        if not run.has("total_energy"):
            continue
        scale = abs(run.initial_energy) if relative == "initial" else relative or 1.0
        if not scale > 0:
            raise ResultsError(f"{run.folder}: the initial energy is zero, so errors cannot be relative to it")
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


def draw_pieces(axes, run, times, values):
    """A history of single steps: mean and, shaded, range of each piece."""
    pieces = pieces_of(values)
    time, mean, low, high = ([function(numbers[piece]) for piece in pieces] for function, numbers in (
        (np.mean, times), (np.mean, values), (np.min, values), (np.max, values)))
    axes.plot(time, mean, color=run.color)
    axes.fill_between(time, low, high, color=run.color, alpha=0.13, linewidth=0)


def draw_iterations(axes, runs):
    """Newton iterations a step: mean and, shaded, range of each piece."""
    for run in runs:
        if run.has("newton_iterations") and len(run["step"]) > 1:
            count = run["newton_iterations"][1:] / np.maximum(np.diff(run["step"]), 1)
            draw_pieces(axes, run, run["time"][1:], count)
    axes.set_ylim(bottom=0)
    axes.yaxis.set_major_locator(MaxNLocator(4, integer=True))


def key(axes, *entries):
    """A legend above a panel."""
    axes.legend(*entries, ncol=4, loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.2, handlelength=1.6)
