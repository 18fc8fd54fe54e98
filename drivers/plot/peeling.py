#!/usr/bin/python3
"""Draws the pull-off force of peeling runs over time or over the driven displacement, or the speed of a probe, or the
kinetic energy. Below the whole curve, each --zoom adds a panel with a detail."""
import numpy as np
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

import curves
import options
import pull
import style
from results import ResultsError, Run, common
from style import plt

EPILOG = """Examples:
  peeling.py strip.results                                      force over time -> strip.results/peeling.png
  peeling.py a.results b.results --zoom 36,46 --zoom 120,140    two details of both runs -> peeling.png
  peeling.py q1c1.results q1c4.results --reference exact.results --against displacement --zoom 10,20,0,0.3
  peeling.py strip.results --speed --probe P --zoom 110,140     -> strip.results/speed.png
  peeling.py a.results b.results --against applied --unit 2,nN --zoom 290,310
  peeling.py a.results b.results --kinetic --zoom 330,350       -> kinetic.png
  peeling.py strip.results --marks 0,20,40,130                  letters at the times that fields.py draws

If the scene moves a set along an oblique line, the force is the component of its reaction along that line.
Reactions of Gautam-Sauer Composite, Average Vector Field, Energy-Momentum and Midpoint are means over a step and are
drawn at its middle. If several runs are compared, a cross marks where one diverged; the panels fit the other runs."""

DASHES = ["-", (0, (5, 3)), (0, (1.5, 2)), (0, (7, 2, 1.5, 2))]


class Curve:
    """The curve of a run: x, y and their labels."""

    def __init__(self, run, arguments):
        self.run = run
        if arguments.speed:
            probe = run.probe("v", arguments.probe)
            self.times, self.y = run["time"], run.speed(probe)
            self.y_label = f"speed of {probe} {style.unit('speed', run.dimension)}"
        elif arguments.kinetic:
            self.times, self.y = run["time"], run["kinetic_energy"]
            self.y_label = f"kinetic energy {style.unit('energy', run.body_dimension)}"
        else:
            kind, self.times, self.y = pull.force(run, arguments.reaction)
            self.y_label = f"{kind} {style.unit('force', run.body_dimension)}"
        self.x, self.x_label = self.times, f"time {style.unit('time', run.dimension)}"
        if arguments.against == "displacement":
            probe = run.probe("u", arguments.displacement)
            self.x = np.interp(self.times, run["time"], run[f"{probe}_u{run.up}"])
            self.x_label = f"displacement of {probe} {style.unit('length', run.dimension)}"
        elif arguments.against == "applied":
            self.x = run.applied(self.times)
            self.x_label = f"applied displacement {style.unit('length', run.dimension)}"
        there = np.isfinite(self.x) & np.isfinite(self.y)
        if not there.any():
            raise ResultsError(f"{run.folder / 'history.csv'} has no values of {self.y_label} over {self.x_label}")
        self.times, self.x, self.y = self.times[there], self.x[there], self.y[there]

    def inside(self, low, high):
        """The values at rows within limits of x."""
        return self.y[(self.x >= low) & (self.x <= high)]

    def part(self, low, high):
        """The values within limits of x, and those at the limits where x rises to them."""
        ends = [x for x in (low, high) if self.x[0] <= x <= self.x[-1] and (np.diff(self.x) >= 0).all()]
        return np.concatenate([self.inside(low, high), np.interp(ends, self.x, self.y)])

    def draw(self, axes, limits=(-np.inf, np.inf)):
        """The curve in a panel of these limits: with points where they are few, without dashes where it swings fast."""
        y = self.inside(*limits[:2])
        steps = np.diff(y)
        swings = np.count_nonzero(np.diff(np.sign(steps)))
        fast = swings > 60 and np.abs(steps).sum() > 10 * np.ptp(y)
        axes.plot(self.x, self.y, color=self.run.color, marker="o" if len(y) <= 25 else None, markersize=3,
                  **(self.run.fast_look if fast else self.run.look))
        if self.run.diverged:
            axes.plot(self.x[-1], self.y[-1], "x", color=self.run.color, markersize=5)


def dress(runs, reference):
    """Looks of the curves: as many may cover each other, dashes lie on a line; the reference broad and grey below."""
    curves.dress(runs)
    for number, run in enumerate(runs):
        run.look = {"linewidth": 1.3 if len(runs) > 1 else 0.9, "linestyle": DASHES[number % len(DASHES)]}
        run.fast_look = {"linewidth": 0.7}
    if reference:
        reference.color, reference.diverged = "#B5B5B5", False
        reference.label = f"reference: {common([reference])}"
        reference.look = reference.fast_look = {"linewidth": 3.5}


def draw_zoom(axes, whole, lines, limits, number):
    """A detail: its panel, and its numbered frame in the whole curve's panel."""
    shown = [(line.run, values) for line in lines if len(values := line.part(*limits[:2]))]
    if not shown:
        raise ResultsError(f"no run has values from {limits[0]:g} to {limits[1]:g} (--zoom)")
    for line in lines:
        line.draw(axes, limits)
    curves.fit(axes, shown)
    if len(limits) == 4:
        axes.set_ylim(limits[2:])
    axes.set_xlim(limits[:2])
    axes.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
    axes.set_title(f"{number}", loc="left", fontweight="bold", pad=3)
    (left, right), (low, high) = (np.clip(ends, *bounds) for ends, bounds in (
        (axes.get_xlim(), whole.get_xlim()), (axes.get_ylim(), whole.get_ylim())))
    whole.add_patch(Rectangle((left, low), right - left, high - low, fill=False, edgecolor=style.INK, linewidth=0.7,
                              zorder=3))
    note(whole, f"{number}", (right, high), (3, -2), va="top", fontweight="bold")


def note(axes, text, place, offset, **look):
    """A word beside a place, readable on curves."""
    axes.annotate(text, place, offset, textcoords="offset points", zorder=4, **look,
                  path_effects=[withStroke(linewidth=2.5, foreground="white")])


def draw_marks(axes, line, times):
    """Letters on a curve at some times."""
    if len(times) > 26:
        raise ResultsError("--marks has more times than there are letters")
    for letter, time in zip("ABCDEFGHIJKLMNOPQRSTUVWXYZ", times):
        if not line.times[0] - line.run["time_step"].max() <= time <= line.times[-1] + line.run["time_step"].max():
            raise ResultsError(f"{line.run.folder} has no time {time:g} to mark (--marks)")
        place = np.interp(time, line.times, line.x), np.interp(time, line.times, line.y)
        axes.plot(*place, "o", color=style.INK, markersize=3, zorder=4)
        note(axes, letter, place, (0, 5), ha="center")


def add_unit(axes, factor, name):
    """A second scale on the right, in another unit."""
    axes.secondary_yaxis("right", functions=(lambda y: factor * y, lambda y: y / factor)).set_ylabel(f"[{name}]")


def draw(lines, marked, arguments):
    """The figure."""
    details = len(arguments.zoom)
    columns = {0: 1, 4: 2}.get(details, min(details, 3))
    rows = -(-details // columns)
    figure = plt.figure(figsize=(7.2, 2.9 + 2.4 * rows), layout="constrained")
    grid = figure.add_gridspec(rows + 1, columns, height_ratios=[1.2] + [1] * rows)
    whole = figure.add_subplot(grid[0, :])
    for line in lines:
        line.draw(whole)
    curves.fit(whole, [(line.run, line.y) for line in lines])
    whole.margins(x=0.02)
    whole.set_xlim(whole.get_xlim())  # frames of details shall not change it
    whole.set(xlabel=lines[0].x_label, ylabel=lines[0].y_label)
    draw_marks(whole, marked, arguments.marks)
    if arguments.unit:
        add_unit(whole, *arguments.unit)
    for number, limits in enumerate(arguments.zoom):
        axes = figure.add_subplot(grid[1 + number // columns, number % columns])
        draw_zoom(axes, whole, lines, limits, number + 1)
        axes.set_xlabel(lines[0].x_label)
        if arguments.unit and number % columns == columns - 1:
            add_unit(axes, *arguments.unit)
        if number % columns == 0:
            axes.set_ylabel(lines[0].y_label)
    return figure


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="a results folder (with history.csv)")
    parser.add_argument("--against", choices=["time", "displacement", "applied"], default="time",
                        help="the abscissa: time, a probe's displacement, or the scene's driven motion (default: time)")
    parser.add_argument("--displacement", metavar="PROBE", help="probe whose displacement normal to the wall is the "
                        "abscissa of --against displacement (default: edge, or the only one)")
    parser.add_argument("--reaction", metavar="NAME", help="column of the force (default: along an oblique pull its "
                        "component along the pull, else the first reaction_*_y, in 3D _z)")
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument("--speed", action="store_true", help="draw the speed of a probe instead of the force")
    kind.add_argument("--kinetic", action="store_true", help="draw the kinetic energy instead of the force")
    parser.add_argument("--unit", type=options.scaled_unit, metavar="FACTOR,NAME",
                        help="add a second scale in the unit NAME: E0 L0^2 (in 2D E0 L0) is FACTOR NAME")
    parser.add_argument("--probe", metavar="PROBE", help="probe of --speed (default: the only one besides "
                        "edge)")
    parser.add_argument("--zoom", type=options.zoom, action="append", default=[], metavar="X0,X1[,Y0,Y1]",
                        help="add a panel for this interval of the abscissa and, if given, the ordinate (repeatable)")
    parser.add_argument("--reference", metavar="FOLDER", help="reference run, drawn broad and grey under the others")
    parser.add_argument("--marks", type=options.numbers, default=[], metavar="T1,T2,...",
                        help="mark these times on the first curve with letters")
    parser.add_argument("--output", metavar="NAME", help="output file, without ending (default: peeling, speed or "
                        "kinetic, in FOLDER or, for several runs, in the working folder)")
    parser.add_figure()
    parser.add_si()
    arguments = parser.parse_args()
    for name, needed, given in (("probe", "--speed", arguments.speed),
                                ("displacement", "--against displacement", arguments.against == "displacement"),
                                ("reaction", "a force, not --speed", not arguments.speed),
                                ("reaction", "a force, not --kinetic", not arguments.kinetic)):
        if getattr(arguments, name) and not given:
            parser.error(f"--{name} needs {needed}")

    runs = [Run(folder) for folder in arguments.folders]
    reference = Run(arguments.reference) if arguments.reference else None
    dress(runs, reference)
    lines = [Curve(run, arguments) for run in ([reference] if reference else []) + runs]
    figure = draw(lines, lines[-len(runs)], arguments)
    if len(lines) == 1:
        figure.suptitle(common(runs), x=0.01, ha="left", fontsize=10, fontweight="bold")
    else:
        handles = [plt.Line2D([], [], color=line.run.color, **line.run.look) for line in lines]
        style.legend(figure, handles, [line.run.label for line in lines], common(runs))
    usual = "speed" if arguments.speed else "kinetic" if arguments.kinetic else "peeling"
    usual = usual if len(runs) > 1 else runs[0].folder / usual
    style.save(figure, arguments.output or usual, arguments.format)


if __name__ == "__main__":
    options.run(main)
