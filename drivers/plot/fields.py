#!/usr/bin/python3
"""Draws the deformed body at several times, coloured by a field: one panel per time, one colour bar."""
import numpy as np
from matplotlib.collections import PolyCollection

import options
import style
import units
from exodus import Fields
from results import ResultsError, flat_wall
from style import plt

EPILOG = """Examples:
  fields.py ball.results                             six evenly spaced times -> ball.results/fields.png
  fields.py ball.results --times 0,0.25,0.29,0.4     the frames nearest to these times
  fields.py spatula.results --range=-0.125,0.25 --view=0.2,-1,0.2
  fields.py ball.results --frames 8 --field jacobian --range 0.9,1.1 --output volume --format png,svg
  fields.py ball.results --field velocityX           a component; of a vector, such as velocity, the magnitude

The folder must contain fields.e or its series fields.e.N.0, ... of one file per rank. A plane body is drawn as its
deformed mesh. VTK renders a body in space, on the X display or, without one, under xvfb-run (Debian packages xvfb and
xauth)."""


def chosen_frames(fields, times, count):
    """Frames at given times, or `count` of even spacing from the first to the last."""
    if times is not None:
        return [fields.nearest_frame(time) for time in times]
    return sorted(set(np.linspace(0, len(fields.times) - 1, count).round().astype(int)))


def draw_body(axes, polygons, values, colors, limits, wall):
    """A deformed mesh coloured by a value a cell, above its wall. Returns the collection."""
    colormap, norm = colors
    # The lines of a fine mesh would hide the colours.
    lines = {"edgecolors": style.INK, "linewidths": 0.35} if len(polygons) < 2000 else {"edgecolors": "face",
                                                                                       "linewidths": 0.2}
    body = PolyCollection(polygons, array=values, cmap=colormap, norm=norm, **lines)
    axes.add_collection(body)
    axes.set(xlim=limits[0], ylim=limits[1], aspect="equal")
    axes.grid(False)
    if wall is not None:
        style.draw_wall(axes, wall)
    return body


def clock(fields, frame):
    """The time of a frame as a title."""
    return f"t = {fields.times[frame]:.4g} {units.name('time', 2)}"


def layout(count, width_to_height):
    """Rows, columns and figure size for `count` panels of that shape: wide rather than high, as pages are."""
    columns = min(range(1, count + 1), key=lambda n: abs(np.log(n * width_to_height / -(-count // n) / 2.2)))
    rows = -(-count // columns)
    columns = -(-count // rows)
    width = min((7.6 - 1.3) / columns, 3.4)
    return rows, columns, (width * columns + 1.3, (width / width_to_height + 0.3) * rows + 0.5)


def draw_plane(fields, frames, values, colors, wall, _):
    """The figure of a plane body."""
    outlines = [fields.polygons(frame) for frame in frames]
    limits = style.box(np.concatenate([polygon for frame in outlines for polygon in frame]), wall)
    rows, columns, size = layout(len(frames), np.diff(limits[0])[0] / np.diff(limits[1])[0])
    figure, grid = plt.subplots(rows, columns, sharex=True, sharey=True, squeeze=False, figsize=size,
                                layout="compressed")
    for axes, frame, polygons, value in zip(grid.flat, frames, outlines, values):
        body = draw_body(axes, polygons, fields.of_wholes(value, frame), colors, limits, wall)
        axes.set_title(clock(fields, frame), pad=3)
        axes.tick_params(direction="out")
        if axes.get_subplotspec().is_first_col():
            axes.set_ylabel(f"y {style.unit('length', 2)}")
    for axes in grid[-1]:
        axes.set_xlabel(f"x {style.unit('length', 2)}")
    return figure, grid, body


def draw_space(fields, frames, values, colors, wall, view):
    """The figure of a body in space, a rendered picture a panel."""
    import render  # VTK's rendering is loaded only where it is needed
    pictures = render.pictures(fields, frames, values, colors, wall, *([view] if view else []))
    rows, columns, size = layout(len(frames), pictures[0].shape[1] / pictures[0].shape[0])
    figure, grid = plt.subplots(rows, columns, squeeze=False, figsize=size, layout="compressed")
    for axes, frame, picture in zip(grid.flat, frames, pictures):
        axes.imshow(picture, interpolation="antialiased")
        axes.set_title(clock(fields, frame), pad=3)
        axes.set_axis_off()
    return figure, grid, plt.cm.ScalarMappable(norm=colors[1], cmap=colors[0])


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="FOLDER", help="a results folder (with fields.e)")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--times", type=options.numbers, metavar="T1,T2,...", help="times of the panels")
    which.add_argument("--frames", type=options.count, default=6, metavar="N",
                       help="number of evenly spaced panels (default: 6)")
    parser.add_argument("--field", default="first_stress_invariant",
                        help="field of cells or of nodes, or a component of one (default: %(default)s); a cell has the "
                        "mean of its nodes")
    parser.add_argument("--range", type=options.interval, metavar="LO,HI",
                        help="limits of the colour bar (default: those of the values drawn; symmetric for stress)")
    wall_options = parser.add_mutually_exclusive_group()
    wall_options.add_argument("--wall", type=float, metavar="HEIGHT", help="height of the wall (default: the scene's)")
    wall_options.add_argument("--no-wall", action="store_true", help="draw no wall")
    parser.add_argument("--view", type=options.direction, metavar="X,Y,Z",
                        help="direction from a body in space to the viewer (default: 0.6,-1,0.4)")
    parser.add_argument("--output", metavar="NAME", help="output file, without ending (default: FOLDER/fields)")
    parser.add_figure()
    parser.add_si()
    arguments = parser.parse_args()

    fields = Fields(arguments.folder, arguments.field)
    wall = arguments.wall
    if wall is None and not arguments.no_wall:
        wall = flat_wall(arguments.folder)
    frames = chosen_frames(fields, arguments.times, arguments.frames)
    values = [fields.element(arguments.field, frame) for frame in frames]
    every = np.concatenate(values)
    if not np.isfinite(every).all():
        raise ResultsError(f"{fields.path}: '{arguments.field}' has no value in some cells of the frames; a field of a "
                           "surface is drawn along it: ixos-plot RESULTS --along SET")
    colors = style.color_scale(arguments.field, every, arguments.range)
    draw = draw_plane if fields.dimension == 2 else draw_space
    figure, grid, body = draw(fields, frames, values, colors, wall, arguments.view)
    for axes in grid.flat[len(frames):]:
        axes.set_visible(False)
    label = style.field_label(arguments.field)
    if not arguments.range and style.is_noise(arguments.field, every):
        figure.suptitle("only rounding errors: drawn in one colour", fontsize=8)
    ends = "both" if arguments.range else "neither"
    bar = figure.colorbar(body, ax=grid, label=label, extend=ends, aspect=30, pad=0.02)
    bar.formatter.set_powerlimits((-3, 4))
    bar.outline.set_linewidth(0.5)
    style.save(figure, arguments.output or fields.path.parent / "fields", arguments.format)


if __name__ == "__main__":
    options.run(main)
