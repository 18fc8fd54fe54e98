#!/usr/bin/python3
"""Draws fields of nodes along a surface at several times: gap, pressure, traction, slip. As a command: ixos-plot RESULTS
--along SET."""
import re
import sys

import numpy as np

import options
import style
import units
from exodus import Fields
from results import ResultsError, Run
from scene_file import is_axisymmetric
from style import plt

EPILOG = """Examples:
  along.py strip.results bottom                        all surface fields at four times -> strip.results/along-bottom.png
  along.py strip.results bottom --times 40,60 --field contact_pressure,gap
  along.py strip.results bottom --field interaction_tractionY,displacementX --data

The set is a node set or a side set of the scene; the curves begin at the lower end of its longer side, in the present
places of its nodes. On a body of revolution that is the radius. In space the set must be a line of nodes, which a
narrow box of the scene's Mesh/Sets chooses. The folder must contain fields.e with fields of nodes: the scene's
Output/Fields chooses them."""

# Without --field: those of surfaces that a file has.
SURFACE = re.compile("gap|contact_pressure|interaction_traction|(gap|pressure|slip|friction|traction)_.*")


def way_along(fields, nodes, set_name):
    """The axis of the longer side of a set, 0 for x, and its nodes along it. A surface that folds back has none."""
    reference = fields.coordinates[nodes]
    sides = np.ptp(reference, axis=0)
    axis = int(np.argmax(sides))
    order = np.argsort(reference[:, axis], kind="stable")
    steps = np.diff(reference[order], axis=0)
    if fields.dimension == 3 and (steps[:, axis] < 1e-9 * sides[axis]).any():
        raise ResultsError(f"{fields.path}: the set '{set_name}' is no line of nodes, since some are beside each other; "
                           "choose one line by a narrow box of the scene's Mesh/Sets")
    if np.linalg.norm(steps, axis=1).sum() > 2 * np.linalg.norm(sides):  # two places at one coordinate
        raise ResultsError(f"{fields.path}: the set '{set_name}' goes back and forth; choose one side of it, by a set of "
                           "the scene's Mesh/Sets")
    return axis, nodes[order]


def surface_fields(folder):
    """The fields of a surface that a folder has; a note on those that it lacks."""
    fields = Fields(folder)
    names = [name for name in fields.nodal_names() if SURFACE.fullmatch(name)]
    if not names:
        raise ResultsError(f"{fields.path} has no field of a surface; Output/Fields of the scene chooses them, such as "
                           f"gap or contact_pressure. Fields of nodes: {', '.join(fields.nodal_names())}")
    if not any(re.match("gap|pressure|contact_pressure|slip", name) for name in names):
        print("note: these fields have no gap, pressure or slip; the scene's Output/Fields lists them, as in --set "
              "'Output/Fields={default, gap, contact_pressure}', and slip_NAME of an interaction with friction",
              file=sys.stderr)
    return names


def values_along(fields, ways, frames, names, asked):
    """By component, the values of each frame; of the fields that nobody asked for, those that differ from zero."""
    values = {}
    for name in names:
        for (_, nodes), frame in zip(ways, frames):
            for component, column in fields.nodal_components(name, frame).items():
                values.setdefault(component, []).append(column[nodes])
    worth = {name: columns for name, columns in values.items()
             if asked or any(np.nan_to_num(column).any() for column in columns)}
    return worth or values


def draw(folder, set_name, asked, times, output, formats):
    """Draws and saves the figure. asked: names of fields, or None; times: of frames, or None, see frames_at()."""
    names = asked or surface_fields(folder)
    fields = Fields(folder, *(asked or names[:1]))
    frames = frames_at(folder, fields, times)
    ways = [way_along(mesh, mesh.nodes_of(set_name), set_name) for mesh, _ in map(fields.on_mesh, frames)]
    axis = ways[0][0]
    values = values_along(fields, ways, frames, names, asked)
    places = [fields.positions(frame)[nodes, axis] for (_, nodes), frame in zip(ways, frames)]
    figure, grid = plt.subplots(len(values), 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(5.2, 1.7 * len(values) + 0.9))
    shades = plt.get_cmap("viridis")(np.linspace(0, 0.85, len(frames)))
    for axes, (name, columns) in zip(grid[:, 0], values.items()):
        for frame, shade, place, column in zip(frames, shades, places, columns):
            kept = np.isfinite(column)  # a node without the field has none
            axes.plot(place[kept], column[kept], color=shade, marker="." if kept.sum() < 2 else None,
                      label=f"t = {fields.times[frame]:.4g} {units.name('time', 2)}")
        label = re.sub("([XYZ])(?= \\[|$)", lambda letter: " " + letter[1].lower(), style.field_label(name))
        axes.set_ylabel(label.replace(" [", "\n["))
    radius = axis == 0 and is_axisymmetric(folder)
    grid[-1, 0].set_xlabel(f"{'radius' if radius else 'xyz'[axis]} {style.unit('length', 2)}")
    grid[0, 0].legend(loc="lower right", bbox_to_anchor=(1, 1), ncol=2, fontsize=8)
    figure.suptitle(f"along {set_name}", x=0.01, ha="left", fontsize=9, fontweight="bold")
    figure.align_ylabels()
    style.save(figure, output or fields.path.parent / f"along-{set_name}", formats)


def frames_at(folder, fields, times, count=4):
    """Frames at given times, or some of a run with the one of the largest force."""
    import fields as configurations
    import overview
    if times is not None:
        return configurations.chosen_frames(fields, times, None)
    return overview.frames_that_matter(Run(folder), fields, count)


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="FOLDER", help="a results folder (with fields.e)")
    parser.add_argument("set", metavar="SET", help="a node set or side set")
    parser.add_along()
    parser.add_argument("--output", metavar="NAME", help="output file, without ending (default: FOLDER/along-SET)")
    parser.add_figure()
    parser.add_si()
    arguments = parser.parse_args()
    draw(arguments.folder, arguments.set, arguments.field, arguments.times, arguments.output, arguments.format)


if __name__ == "__main__":
    options.run(main)
