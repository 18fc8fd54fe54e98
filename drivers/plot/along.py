#!/usr/bin/python3
"""Draws fields of nodes along a surface at several times: gap, pressure, traction, slip. As a command: ixos-plot RESULTS
--along SET."""
import re

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
places of its nodes. On a body of revolution that is the radius. The folder must contain fields.e with fields of nodes:
the scene's Output/Fields chooses them."""

# Without --field: those of surfaces that a file has.
SURFACE = re.compile("gap|contact_pressure|interaction_traction|(gap|pressure|slip|friction|traction)_.*")


def places(fields, nodes, frame):
    """The axis of the longer side of a set, 0 for x, the order of its nodes along it, and their present places."""
    reference = fields.coordinates[nodes]
    axis = int(np.argmax(np.ptp(reference, axis=0)))
    order = np.argsort(reference[:, axis], kind="stable")
    return axis, order, (fields.coordinates + fields.displacement(frame))[nodes][order, axis]


def chosen_names(fields, nodes, frames, asked):
    """The fields to draw, by the names of their components; of those that nobody asked for, what differs from zero."""
    names = asked or [name for name in fields.nodal_names() if SURFACE.fullmatch(name)]
    if not names:
        raise ResultsError(f"{fields.path} has no field of a surface; Output/Fields of the scene chooses them, such as "
                           f"gap or contact_pressure. Fields of nodes: {', '.join(fields.nodal_names())}")
    result = []
    for name in names:
        columns = [fields.nodal_components(name, frame) for frame in frames]
        result += [component for component in columns[0]
                   if asked or any(np.nan_to_num(column[component][nodes]).any() for column in columns)]
    return result or names


def curves(fields, nodes, name, frames):
    """(place, value) of each frame; nodes without the field are left out."""
    for frame in frames:
        _, order, place = places(fields, nodes, frame)
        values = next(iter(fields.nodal_components(name, frame).values()))[nodes][order]
        kept = np.isfinite(values)
        yield place[kept], values[kept]


def refuse_folds(fields, nodes, set_name):
    """Curves need a surface that goes one way: a closed one has two places at one coordinate."""
    reference = fields.coordinates[nodes]
    _, order, _ = places(fields, nodes, 0)
    way = np.linalg.norm(np.diff(reference[order], axis=0), axis=1).sum()
    if way > 2 * np.linalg.norm(np.ptp(reference, axis=0)):
        raise ResultsError(f"{fields.path}: the set '{set_name}' goes back and forth; choose one side of it, by a set of "
                           "the scene's Mesh/Sets")


def draw(folder, set_name, names, frames, output, formats):
    """Draws and saves the figure. names: of fields, or None; frames: their numbers."""
    fields = Fields(folder)
    if fields.dimension != 2:
        raise ResultsError(f"{fields.path}: curves are along the surfaces of plane bodies and bodies of revolution; "
                           "ParaView cuts a body in space")
    nodes = fields.nodes_of(set_name)
    refuse_folds(fields, nodes, set_name)
    names = chosen_names(fields, nodes, frames, names)
    axis = places(fields, nodes, frames[0])[0]
    figure, grid = plt.subplots(len(names), 1, sharex=True, squeeze=False, layout="constrained",
                                figsize=(5.2, 1.7 * len(names) + 0.9))
    shades = plt.get_cmap("viridis")(np.linspace(0, 0.85, len(frames)))
    for axes, name in zip(grid[:, 0], names):
        for frame, shade, (place, values) in zip(frames, shades, curves(fields, nodes, name, frames)):
            axes.plot(place, values, color=shade, label=f"t = {fields.times[frame]:.4g} {units.name('time', 2)}",
                      marker="." if len(place) < 2 else None)
        label = re.sub("([XYZ])(?= \\[|$)", lambda axis: " " + axis[1].lower(), style.field_label(name))
        axes.set_ylabel(label.replace(" [", "\n["))
    radius = axis == 0 and is_axisymmetric(folder)
    grid[-1, 0].set_xlabel(f"{'radius' if radius else 'xy'[axis]} {style.unit('length', 2)}")
    grid[0, 0].legend(loc="lower right", bbox_to_anchor=(1, 1), ncol=2, fontsize=8)
    figure.suptitle(f"along {set_name}", x=0.01, ha="left", fontsize=9, fontweight="bold")
    figure.align_ylabels()
    style.save(figure, output or fields.path.parent / f"along-{set_name}", formats)


def frames_at(folder, times, count=4):
    """Frames at given times, or some of a run with the one of the largest force."""
    import fields as configurations
    import overview
    fields = Fields(folder)
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
    frames = frames_at(arguments.folder, arguments.times)
    draw(arguments.folder, arguments.set, arguments.field, frames, arguments.output, arguments.format)


if __name__ == "__main__":
    options.run(main)
