#!/usr/bin/python3
"""Draws a first picture of a run: configurations with the force that pulls, the force or else the energies over time, and
the gap. As a command: ixos-plot RESULTS."""
import sys
import textwrap

import numpy as np

import curves
import measures
import options
import pull
import style
import units
from exodus import Fields
from results import UNDAMPED, ResultsError, Run, flat_wall
from style import plt

EPILOG = """Examples:
  ixos-plot ball.results                      -> ball.results/overview.png
  ixos-plot strip.results --si --format svg   in SI units -> strip.results/overview.svg
  ixos-plot strip.results --along bottom      gap, pressure, ... along a surface -> strip.results/along-bottom.png

Configurations need fields.e (the scene must set Output/Fields Interval). An arrow shows the reaction of the set that the
scene pulls, the longest one the largest force drawn. Forces and energies of plane bodies are per depth. The other
scripts draw more, and compare runs: they are in drivers/plot, and in share/ixos/plot of an installed Ixos."""

WIDTH, LETTERS = 7.6, 110  # inches of a figure, and of its headline
PANELS, NARROW = 4, 5.0  # configurations; inches of a figure that has room for half of them


def read_fields(folder):
    """The fields, or None with a note where there are none or they cannot be read."""
    try:
        return Fields(folder, "first_stress_invariant")
    except ResultsError as error:
        print(f"no configurations: {error}", file=sys.stderr)
        return None


def reaction_vectors(run, fields, frames):
    """Places and vectors of the reactions of the pulled set at some frames, or None. A row a frame."""
    motion = pull.direction(run)
    if motion is None or fields.dimension != 2:
        return None
    node_set = motion[0]
    parts = [run.reaction(f"{node_set}_{axis}") for axis in "xy"]
    places = [fields.node_set(node_set, frame) for frame in frames]
    if any(len(place) == 0 for place in places):
        return None
    forces = np.array([np.interp(fields.times[frames], times, values) for _, times, values in parts]).T
    if run.body_dimension > run.dimension:
        forces[:, 0] = 0  # those of all angles balance around the axis
    return np.array([place.mean(axis=0) for place in places]), forces


def arrows_of(vectors, limits):
    """(from, to) of an arrow a frame; None for a force of less than a hundredth of the largest. The longest has a sixth
    of the panel's diagonal."""
    largest = np.linalg.norm(vectors[1], axis=1).max() if vectors else 0.0
    length = np.hypot(*(high - low for low, high in limits)) / 6
    if not largest > 0:
        return []
    return [(place, place + length * force / largest) if np.linalg.norm(force) > 0.01 * largest else None
            for place, force in zip(*vectors)]


def draw_arrow(axes, arrow):
    """A force."""
    axes.annotate("", arrow[1], arrow[0], annotation_clip=False, arrowprops={
        "arrowstyle": "-|>", "color": style.COLORS[2], "linewidth": 1.4, "shrinkA": 0, "shrinkB": 0})


def frames_that_matter(run, fields, count):
    """So many frames, the last one among them, from the first on at equal distances. Among them are the one at the
    largest force, or else the last before it and, of four or more, the first after it."""
    import fields as configurations  # VTK, too
    frames = configurations.chosen_frames(fields, None, count)
    if not any(np.isfinite(values).any() for _, _, values in run.reactions()):
        return frames
    _, times, values = pull.force(run)
    at = times[np.nanargmax(np.abs(values))]
    near = 1e-6 * (fields.times[-1] - fields.times[0])
    before, after = np.flatnonzero(fields.times <= at + near), np.flatnonzero(fields.times >= at - near)
    wanted = {int(frame) for frame in (*before[-1:], *(after[:1] if len(frames) > 3 else ()))}
    others = [frame for frame in frames if frame not in wanted]
    while others and len(others) + len(wanted) > len(frames):
        inner = [frame for frame in others if frame not in (frames[0], frames[-1])] or others[:1]
        others.remove(min(inner, key=lambda frame: min(abs(frame - one) for one in wanted)))
    return sorted(wanted.union(others))


def draw_configurations(figure, run, fields):
    """A row of configurations, see frames_that_matter()."""
    import fields as configurations  # VTK, too
    width = style.output.width
    frames = frames_that_matter(run, fields, PANELS // 2 if width and width < NARROW else PANELS)
    values = [fields.element("first_stress_invariant", frame) for frame in frames]
    every = np.concatenate(values)
    colors = style.color_scale("first_stress_invariant", every)
    wall = flat_wall(run.folder)
    grid = figure.subplots(1, len(frames), sharey=True, squeeze=False)
    if fields.dimension == 3:
        import render  # VTK's rendering is loaded only where it is needed
        for axes, picture in zip(grid.flat, render.pictures(fields, frames, values, colors, wall)):
            axes.imshow(picture, interpolation="antialiased")
            axes.set_axis_off()
    else:
        outlines = [fields.polygons(frame) for frame in frames]
        points = np.concatenate([polygon for frame in outlines for polygon in frame])
        arrows = arrows_of(reaction_vectors(run, fields, frames), style.box(points, wall))
        limits = style.box(np.concatenate([points] + [arrow[1][None] for arrow in arrows if arrow]), wall)
        for axes, frame, polygons, value in zip(grid.flat, frames, outlines, values):
            configurations.draw_body(axes, polygons, fields.of_wholes(value, frame), colors, limits, wall)
            axes.set_xlabel(f"x {style.unit('length', 2)}")
        grid[0, 0].set_ylabel(f"y {style.unit('length', 2)}")
        for axes, arrow in zip(grid.flat, arrows):
            if arrow:
                draw_arrow(axes, arrow)
    for axes, frame in zip(grid.flat, frames):
        axes.set_title(configurations.clock(fields, frame), pad=3)
    label = style.field_label("first_stress_invariant")
    if style.is_noise("first_stress_invariant", every):
        label = "no stress"
    bar = figure.colorbar(plt.cm.ScalarMappable(norm=colors[1], cmap=colors[0]), ax=grid, label=label, aspect=12,
                          pad=0.02)
    bar.formatter.set_powerlimits((-3, 4))
    bar.outline.set_linewidth(0.5)


def draw_force(axes, run):
    """The force, with the names of its events."""
    kind, times, values = pull.force(run)
    axes.plot(times, values, color=style.COLORS[0])
    axes.set_ylabel(f"{kind.replace(' (', chr(10) + '(')}\n{style.unit('force', run.body_dimension)}")
    if not run.has("contact_measure"):
        return
    for name in ("start of peeling", "snap-off"):
        time, value = measures.event_peak(name, times, values, run["time"], run["contact_measure"])
        if np.isfinite(time) and times[0] < time < times[-1]:
            axes.plot(time, value, "o", color=style.INK, markersize=3, zorder=4)
            words = f"{name}: {value:.3g} {units.name('force', run.body_dimension)}"
            axes.annotate(words, (time, value), (0, 4), textcoords="offset points",
                          ha="right" if time > times[-1] / 2 else "left", va="bottom", fontsize=8)
    axes.margins(y=0.2)


def panels(run):
    """(height, function that draws) of the panels over time."""
    force = any(np.isfinite(values).any() for _, _, values in run.reactions())
    energy = style.unit("energy", run.body_dimension)

    def draw_energies(axes):
        curves.draw_energies(axes, run)
        axes.set_ylabel(f"energy\n{energy}")

    def draw_gap(axes):
        axes.set_yscale("log" if np.nanmin(run["min_gap"]) > 0 else "linear")
        curves.draw_column(axes, [run], "min_gap")
        axes.set_ylabel(f"least gap\n{style.unit('length', run.dimension)}")

    rows = []
    if force:
        rows.append((1.5, lambda axes: draw_force(axes, run)))
    elif run.has("total_energy"):
        rows.append((1.7, draw_energies))
    if run.has("min_gap"):
        rows.append((1.0, draw_gap))
    return rows


def headline(run):
    """Scheme and step; how the run ended where it did not come to its end. A narrow figure has shorter lines."""
    status, reason = run.summary.get("status"), run.summary.get("reason")
    words = [word for word in run.traits() if word not in (None, UNDAMPED)]
    if not status:
        words.append("not ended")
    elif status != "completed":
        words.append(status + (f": {reason}" if reason else ""))
    return textwrap.fill(", ".join(words), max(40, int(LETTERS * min(1, (style.output.width or WIDTH) / WIDTH))))


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="RESULTS", help="a results folder (with history.csv)")
    parser.add_argument("--output", metavar="NAME", help="output file, without ending (default: RESULTS/overview, or along-SET)")
    parser.add_argument("--along", metavar="SET", help="draw curves along a node set or side set instead")
    parser.add_along()
    parser.add_figure()
    parser.add_si()
    arguments = parser.parse_args()
    if arguments.along:
        import along
        return along.draw(arguments.folder, arguments.along, arguments.field, arguments.times, arguments.output,
                          arguments.format)
    if arguments.times or arguments.field:
        parser.error("--times and --field belong to --along SET; fields.py draws other configurations")

    run = Run(arguments.folder)
    curves.dress([run])
    fields, rows = read_fields(arguments.folder), panels(run)
    if not rows and fields is None:
        raise ResultsError(f"{run.folder} has nothing that can be drawn: no frames, reactions, energies or gaps")
    heights = [1.05 * height for height, _ in rows]
    figure = plt.figure(figsize=(WIDTH, sum(heights) + 0.9 + (2.1 if fields else 0)), layout="constrained")
    parts = figure.subfigures(2 if fields and rows else 1, 1, squeeze=False,
                              height_ratios=[2.1, sum(heights) + 0.6] if fields and rows else None)[:, 0]
    if fields:
        try:
            draw_configurations(parts[0], run, fields)
        except (ResultsError, ImportError) as error:  # a body in space needs VTK and a display
            print(f"no configurations: {error}", file=sys.stderr)
    if rows:
        grid = parts[-1].subplots(len(rows), 1, sharex=True, squeeze=False, height_ratios=heights)[:, 0]
        for axes, (_, draw) in zip(grid, rows):
            draw(axes)
        grid[-1].set_xlabel(f"time {style.unit('time', run.dimension)}")
        if run["time"][-1] > run["time"][0]:
            grid[-1].set_xlim(run["time"][0], run["time"][-1])
        parts[-1].align_ylabels()
    figure.suptitle(headline(run), x=0.01, ha="left", fontsize=9, fontweight="bold")
    return style.save(figure, arguments.output or run.folder / "overview", arguments.format)


if __name__ == "__main__":
    options.run(main)
