"""Triangles and tetrahedra of gmsh that are fine at the contact, beside quadrilaterals."""
import itertools
import math

from .. import bodies
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved, measures, results
from ..table import Column, Table
from .elements import peak

PAGE = "docs/results/elements.md"
DRAWING = "Mesh/Gmsh/Drawing"


def quads(along, across, kind, contact):
    """Returns the settings of the scene's own cells."""
    return [bodies.divisions(along, across), *(["Mesh/Cell Order=2"] if kind == "quadratic" else []),
            f"Interactions/Wall/Contact Element={contact}"]


def constants(**values):
    """Returns the settings of constants of a drawing."""
    return [f"{DRAWING}/Constants/{name}={value}" for name, value in values.items()]


def of_drawing(name):
    """Returns the settings of a drawing's mesh in quadratic triangles with curved sides."""
    return ["Mesh/Type=Gmsh", f"Mesh/Gmsh/File=../meshes/{name}.geo", f"{DRAWING}/Order=2",
            "Interactions/Wall/Contact Element=Q1C1"]


def strip(fine, coarse, growth):
    return [*of_drawing("rectangle"), *constants(bottom=0.254709287789268, length=200.0, height=10.0, to=150.0,
                                                 fine=fine, coarse=coarse, growth=growth)]


def meridian(fine):
    return ["Mesh/Map/X=x", "Mesh/Map/Y=y", *of_drawing("jkr-sphere"),
            *constants(solid=0, reach=30.0, fine=fine, growth=0.4)]


# By scene: reaction, settings of every run, interval and window of the ripple, the reference, and the cells; quadratic
# ones are the base of the ratios.
SCENES = {
    "strip": ("right_y", [f"{SCHEME}=Static", f"{TIME_STEP}=0.1", f"{FINAL_TIME}=30", "Histories/Pull/Rate Ramp/Length=1"],
              ((18, 28), 2), quads(640, 8, "quadratic", "Q2C2"),
              {"quadratic, 160 x 2": quads(160, 2, "quadratic", "Q2C2"),
               "quadratic, Q2C4, 160 x 2": quads(160, 2, "quadratic", "Q2C4"),
               "linear, Q1C4, 320 x 16": quads(320, 16, "linear", "Q1C4"),
               "triangles, 1.2 at the contact": strip(1.2, 4.0, 0.5),
               "triangles, 1.0 at the contact": strip(1.0, 3.0, 0.4),
               "triangles, 0.8 at the contact": strip(0.8, 2.5, 0.4)}),
    "jkr": ("top_y", [], ((1.1, 1.5), 0.1), quads(184, 44, "quadratic", "Q2C4"),
            {"quadratic, 46 x 11": quads(46, 11, "quadratic", "Q2C2"),
             "quadratic, Q2C4, 46 x 11": quads(46, 11, "quadratic", "Q2C4"),
             "linear, Q1C4, 92 x 22": quads(92, 22, "linear", "Q1C4"),
             "triangles, 4 at the contact": meridian(4.0),
             "triangles, 2 at the contact": meridian(2.0),
             "triangles, 1.5 at the contact": meridian(1.5)}),
}


def reaction(context, component, name="run"):
    """Returns the times and the forces of a run."""
    _, times, force = results.Run(context.folder / name).reaction(component)
    return times, force


def measure_triangles(context):
    rows = []
    for scene, (component, settings, (interval, window), reference, cells) in SCENES.items():
        cells = dict(itertools.islice(cells.items(), context.pick(None, 1))) | context.pick(
            {}, {"triangles": list(cells.values())[3]})
        context.run(scene, [*settings, *context.pick(reference, list(cells.values())[0])], name="reference")
        exact = peak(reaction(context, component, "reference")[1])

        def sample(name):
            summary = context.run(scene, [*settings, *cells[name]])
            times, force = reaction(context, component)
            return {"seconds": summary["wall_seconds"], "dofs": summary["dofs"], "error": abs(peak(force) / exact - 1),
                    "ripple": measures.oscillation(times, force, interval, window)[1],
                    "iterations": summary["newton_iterations"] / summary["steps"]}

        for name, found in interleaved(cells, context.pick(3, 1), sample).items():
            rows.append({"scene": scene, "cells": name, "time": found.ratio["seconds"],
                         **{key: found.median[key] for key in ("error", "ripple", "iterations", "seconds")},
                         "dofs": int(found.median["dofs"])})
    return rows


FINE = (6.0, 4.0, 2.0)  # nm, at the contact


def measure_tetrahedra(context):
    """Compares the pull-off force of a quarter of the sphere with that of the body of revolution."""
    context.run("jkr", quads(184, 44, "quadratic", "Q2C4") if not context.trial else [], name="reference")
    exact = peak(reaction(context, "top_y", "reference")[1])
    rows = []
    for fine in context.pick(FINE, FINE[:1]):
        summary = context.run("meshes/jkr-sphere.xml", [*constants(fine=fine), *context.pick([], [f"{TIME_STEP}=0.05"])])
        force = 4 * reaction(context, "top_y")[1]
        rows.append({"cells": f"tetrahedra, {fine:g} nm at the contact", "error": peak(force) / exact - 1,
                     "theory": peak(force) / (math.pi * 1000 * 0.01549567), "dofs": summary["dofs"],
                     "iterations": summary["newton_iterations"] / summary["steps"], "seconds": summary["wall_seconds"]})
    return rows


TABLES = [
    Table(name="elements-triangles", page=PAGE, code=bodies.MECHANICS, minutes=4, measure=measure_triangles,
          columns=[Column("scene"), Column("cells"), Column("error of the peak", "{:.1e}", "error"),
                   Column("ripple", "{:.1e}"), Column("time to the first row of the scene", "{:.2f}", "time"),
                   Column("degrees of freedom", "{:,}", "dofs"), Column("iterations a step", "{:.2f}", "iterations"),
                   Column("s", "{:.2f}", "seconds")]),
    Table(name="elements-tetrahedra", page=PAGE, code=bodies.MECHANICS, minutes=5, measure=measure_tetrahedra,
          columns=[Column("cells"), Column("difference from the body of revolution", "{:+.2%}", "error"),
                   Column("pull-off force over pi R W", "{:.4f}", "theory"),
                   Column("degrees of freedom", "{:,}", "dofs"), Column("iterations a step", "{:.2f}", "iterations"),
                   Column("s", "{:.0f}", "seconds")]),
]
