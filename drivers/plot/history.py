#!/usr/bin/python3
"""Draws the history of one run or compares several: energies, energy error, angular momentum, least gap, contact
force, reactions and Newton iterations over time. Columns that a run did not write are left out."""
import curves
import options
import style
from results import ResultsError, Run
from style import plt

EPILOG = """Examples:
  history.py ball.results                            -> ball.results/history.png
  history.py a.results b.results --output compared   -> compared.png
  history.py a.results b.results --relative initial  energy errors over the magnitude of the initial energy
  history.py a.results b.results --relative 0.155    energy errors over a scale of your own [E0 L0^2; E0 L0^3 in 3D]

Fast oscillations are drawn faint, and their mean over each 1/60 of the time strong; --time shows a part in full detail.
Reactions of Gautam-Sauer Composite, Average Vector Field, Energy-Momentum and Midpoint are means over a step and are
drawn at its middle. If several runs are compared, a cross marks where one diverged; linear axes fit the other runs."""


def panels(runs, relative):
    """(height, label, log axis?, function that draws) of each panel that has something to show."""
    dimension = max(run.dimension for run in runs)
    body = max(run.body_dimension for run in runs)
    energy, force = style.unit("energy", body), style.unit("force", body)
    contact = "contact_force_z" if dimension == 3 else "contact_force_y"
    over = {None: energy, "initial": "/ |initial energy|"}.get(relative, f"/ {relative} {energy.strip('[]')}")
    several = len(runs) > 1

    def has(column):
        return any(run.has(column) for run in runs)

    def column(name):
        return lambda axes: curves.draw_column(axes, runs, name)

    table = [
        (not several and has("kinetic_energy"), 1.8, f"energy\n{energy}", False,
         lambda axes: curves.draw_energies(axes, runs[0])),
        (several and has("total_energy"), 1.2, f"total energy\n{energy}", False,
         lambda axes: curves.draw_total(axes, runs)),
        (several and has("kinetic_energy"), 1.2, f"kinetic energy\n{energy}", False, column("kinetic_energy")),
        (has("total_energy"), 1.2, f"energy error\n{over}", True,
         lambda axes: curves.draw_errors(axes, runs, relative)),
        (several and has("angular_momentum_z"), 0.9, f"angular mo-\nmentum z\n{style.unit('angular momentum', body)}", False, column("angular_momentum_z")),
        (has("min_gap"), 1.0, f"least gap\n{style.unit('length', dimension)}", True, column("min_gap")),
        (has(contact), 1.2, f"contact force {contact[-1]}\n{force}", False, column(contact)),
        (any(run.reactions() for run in runs), 1.2, f"reaction\n{force}", False,
         lambda axes: curves.draw_reactions(axes, runs)),
        (has("newton_iterations"), 0.8, "Newton\niterations", False, lambda axes: curves.draw_iterations(axes, runs)),
    ]
    return [row[1:] for row in table if row[0]]


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="a results folder (with history.csv)")
    parser.add_argument("--output", metavar="NAME", help="output file, without ending (default: FOLDER/history; "
                        "for several runs, history in the working folder)")
    parser.add_figure()
    parser.add_argument("--relative", type=options.scale, metavar="initial|SCALE",
                        help="divide energy errors by the initial energy or by a number")
    parser.add_argument("--time", type=options.interval, metavar="FROM,TO", help="times to draw (default: all)")
    parser.add_si()
    arguments = parser.parse_args()

    runs = [Run(folder, arguments.time) for folder in arguments.folders]
    curves.dress(runs)
    rows = panels(runs, arguments.relative)
    if not rows:
        raise ResultsError("history.csv of these runs has no column that can be drawn")
    heights = [row[0] for row in rows]
    figure, grid = plt.subplots(len(rows), 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(7.2, 1.05 * sum(heights) + 0.7), height_ratios=heights)
    for axes, (_, label, log, draw) in zip(grid[:, 0], rows):
        axes.set_yscale("log" if log else "linear")
        draw(axes)
        axes.set_ylabel(label)
    grid[-1, 0].set_xlabel(f"time {style.unit('time', 2)}")
    start, end = min(run["time"][0] for run in runs), max(run["time"][-1] for run in runs)
    if end > start:
        grid[-1, 0].set_xlim(start, end)
    figure.align_ylabels()
    if len(runs) == 1:
        figure.suptitle(runs[0].label, x=0.01, ha="left", fontsize=10, fontweight="bold")
    else:
        lines = [plt.Line2D([], [], color=run.color, linewidth=1.6) for run in runs]
        style.legend(figure, lines, [run.label for run in runs])
    usual = "history" if len(runs) > 1 else runs[0].folder / "history"
    style.save(figure, arguments.output or usual, arguments.format)


if __name__ == "__main__":
    options.run(main)
