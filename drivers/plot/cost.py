#!/usr/bin/python3
"""Draws the cost of runs: wall-clock time and Newton iterations per increment. Each scheme has a bar, each contact
element a group of bars, each time step a column of panels."""
import numpy as np
from matplotlib.ticker import MaxNLocator

import options
import style
from results import ResultsError, Run
from style import plt

EPILOG = """Examples:
  cost.py *.results                                  -> cost.png in the working folder
  cost.py a.results b.results --output strip --format png,svg

Scheme and cost are read from summary.json, contact element and time step from effective.xml. Runs with the same scheme,
element and time step are repetitions: the bar is their median, points show the single runs. A cross marks a run that
diverged. summary_table.py --columns peeling prints the numbers."""

ROWS = {
    "time an increment\n[ms]": lambda run: 1e3 * run.summary["seconds_per_increment"],
    "Newton iterations\nan increment": lambda run: run.summary["newton_iterations"] / max(run.summary["steps"], 1),
}


def checked(folder):
    """A run that tells all that is needed."""
    run = Run(folder)
    for name in ("seconds_per_increment", "newton_iterations", "steps"):
        if name not in run.summary:
            raise ResultsError(f"{run.folder / 'summary.json'} has no entry '{name}'")
    if run.time_step is None:
        raise ResultsError(f"{run.folder / 'effective.xml'} has no time step")
    return run


def draw_bars(axes, runs, schemes, elements, cost):
    """The bars of one time step."""
    width = min(0.8 / len(schemes), 0.3)
    for number, scheme in enumerate(schemes):
        for place, element in enumerate(elements):
            repeats = [run for run in runs if (run.scheme, run.element or "") == (scheme, element)]
            if not repeats:
                continue
            costs, x = [cost(run) for run in repeats], place + width * (number - (len(schemes) - 1) / 2)
            axes.bar(x, np.median(costs), 0.88 * width, color=style.COLORS[number % len(style.COLORS)])
            if len(repeats) > 1:
                axes.plot([x] * len(costs), costs, "o", color=style.INK, markersize=2.5)
            if any(run.summary.get("status") == "diverged" for run in repeats):
                axes.plot(x, max(costs), "x", color=style.INK, markersize=5, clip_on=False)


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER",
                        help="a results folder (with history.csv, summary.json, effective.xml)")
    parser.add_argument("--output", metavar="NAME", default="cost",
                        help="output file, without ending (default: cost)")
    parser.add_figure()
    arguments = parser.parse_args()

    runs = [checked(folder) for folder in arguments.folders]
    schemes = list(dict.fromkeys(run.scheme for run in runs))
    steps = sorted({run.time_step for run in runs}, reverse=True)
    elements = {step: sorted({run.element or "" for run in runs if run.time_step == step}) for step in steps}
    groups = [len(elements[step]) for step in steps]
    figure, grid = plt.subplots(len(ROWS), len(steps), sharex="col", sharey="row", squeeze=False, layout="constrained",
                                figsize=(min(2.2 + 0.25 * len(schemes) * sum(groups), 7.2), 4.2), width_ratios=groups)
    for row, (label, cost) in zip(grid, ROWS.items()):
        for axes, step in zip(row, steps):
            draw_bars(axes, [run for run in runs if run.time_step == step], schemes, elements[step], cost)
            axes.set_xticks(range(len(elements[step])), elements[step])
            axes.set_xlim(-0.5, len(elements[step]) - 0.5)
            axes.tick_params(axis="x", length=0)
            axes.grid(False, axis="x")
        row[0].set_ylabel(label)
        row[0].yaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 5, 10]))
    for axes, step in zip(grid[0], steps):
        axes.set_title(f"Δt = {step:g} {style.unit('time', 2).strip('[]')}")
    figure.align_ylabels()
    handles = [plt.Rectangle((0, 0), 1, 1, color=style.COLORS[number % len(style.COLORS)])
               for number in range(len(schemes))]
    style.legend(figure, handles, schemes)
    style.save(figure, arguments.output, arguments.format)


if __name__ == "__main__":
    options.run(main)
