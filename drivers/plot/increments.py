#!/usr/bin/python3
"""Draws the cost of each increment over time: wall-clock time, Newton iterations and time per iteration."""
import numpy as np

import curves
import options
import style
from results import ResultsError, Run, common
from style import plt

EPILOG = """Examples:
  increments.py newmark.results bathe.results composite.results      -> increments.png in the working folder
  increments.py spatula.results --time 0,100 --logarithmic

A line is the mean over each 1/60 of the steps, which removes the noise of the clock; the shaded band shows the range of
single increments. The times include output and checkpoints. cost.py draws bars of whole runs."""


def increments(run):
    """Times at the end of each row's increments, seconds an increment, Newton iterations an increment."""
    for name in ("wall_seconds", "newton_iterations"):
        if not run.has(name):
            raise ResultsError(f"{run.folder / 'history.csv'} has an empty column '{name}'")
    if len(run["step"]) < 2:
        raise ResultsError(f"{run.folder / 'history.csv'} has no increments")
    steps, seconds = np.diff(run["step"]), np.diff(run["wall_seconds"])
    there = (steps > 0) & (seconds >= 0)  # a restart's clock may begin anew
    times, iterations, steps = run["time"][1:][there], run["newton_iterations"][1:][there], steps[there]
    return times, seconds[there] / steps, iterations / steps


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="a results folder (with history.csv)")
    parser.add_argument("--time", type=options.interval, metavar="FROM,TO", help="times to draw (default: all)")
    parser.add_argument("--logarithmic", action="store_true", help="use logarithmic axes for wall-clock times")
    parser.add_argument("--output", metavar="NAME", default="increments",
                        help="output file, without ending (default: increments)")
    parser.add_figure()
    parser.add_si()
    arguments = parser.parse_args()

    runs = [Run(folder, arguments.time) for folder in arguments.folders]
    curves.dress(runs)
    figure, grid = plt.subplots(3, 1, sharex=True, figsize=(7.2, 6.2), layout="constrained")
    for run in runs:
        times, seconds, iterations = increments(run)
        curves.draw_pieces(grid[0], run, times, seconds)
        curves.draw_pieces(grid[1], run, times, iterations)
        some = iterations > 0
        if some.any():
            curves.draw_pieces(grid[2], run, times[some], seconds[some] / iterations[some])
    labels = "time an increment\n[s]", "Newton iterations\nan increment", "time an iteration\n[s]"
    for axes, label in zip(grid, labels):
        axes.set_ylabel(label)
        if arguments.logarithmic and axes is not grid[1]:
            axes.set_yscale("log")
        else:
            axes.set_ylim(bottom=0)
    grid[-1].set_xlabel(f"time {style.unit('time', runs[0].dimension)}")
    figure.align_ylabels()
    handles = [plt.Line2D([], [], color=run.color, linewidth=1.6) for run in runs]
    style.legend(figure, handles, [run.label for run in runs], common(runs) if len(runs) > 1 else None)
    style.save(figure, arguments.output, arguments.format)


if __name__ == "__main__":
    options.run(main)
