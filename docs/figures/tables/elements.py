"""Cells and contact elements: what they cost for their accuracy, and how fast the peak force converges."""
import itertools

import numpy as np

from .. import bodies
from ..runs import Failure, FINAL_TIME, SCHEME, TIME_STEP, interleaved, measures, results
from ..table import Column, Table

PAGE = "docs/results/elements.md"
PICTURE = "tests/bench/error_over_time.py"  # draws the data of two tables


def cells(kind, contact, material):
    """Returns the settings of a kind of cells with a contact element. material: name of the body's material."""
    kinds = {"linear": [], "quadratic": ["Mesh/Cell Order=2"],
             "Enhanced": [f"Materials/{material}/Element Formulation=Enhanced"]}
    return [*kinds[kind], f"Interactions/Wall/Contact Element={contact}"]


def error_of_force(context, name, reaction, window):
    """Returns the rms difference of a run's pull-off force from that of the run `reference`, over the force's rms."""
    (_, *found), (_, *fine) = (results.Run(context.folder / folder).reaction(reaction) for folder in (name, "reference"))
    return measures.deviation(*found, *fine, window)[1]


# The strip: cells along and across it. The first row is the base of the ratios.
STRIP = (("quadratic", "Q2C2", 120, 2), ("quadratic", "Q2C2", 80, 1), ("quadratic", "Q2C2", 200, 3),
         ("quadratic", "Q2C2", 320, 2), ("Enhanced", "Q1C2", 80, 4), ("Enhanced", "Q1C4", 160, 4),
         ("Enhanced", "Q1C4", 160, 8), ("Enhanced", "Q1C4", 320, 8), ("linear", "Q1C1", 160, 4),
         ("linear", "Q1C4", 160, 8), ("linear", "Q1C4", 320, 16))
SCHEMES = {"Newmark": 4.0, "Static": 16.0}  # and their steps, T0


def strip(mesh, scheme, step, end):
    """Returns the settings of a run of the strip."""
    kind, contact, along, across = mesh
    return [bodies.divisions(along, across), *cells(kind, contact, "Strip"), f"{SCHEME}={scheme}",
            f"{TIME_STEP}={step}", f"{FINAL_TIME}={end}"]


def measure_strip(context):
    """Times each mesh with each scheme, and compares its force with that of a fine mesh in short steps."""
    meshes, end = context.pick(STRIP, STRIP[:2] + STRIP[8:9]), context.pick(120, 60)
    fine, step = context.pick((("quadratic", "Q2C2", 320, 8), 0.2), (("quadratic", "Q2C2", 160, 3), 1.0))
    context.run("strip", strip(fine, "Newmark", step, end), name="reference")

    def error(mesh, scheme):
        """The largest error of the step and of half of it: a long step may come near the force by chance."""
        found = []
        for shorter in (1, 2):
            context.run("strip", strip(mesh, scheme, SCHEMES[scheme] / shorter, end))
            found.append(error_of_force(context, "run", "right_y", (20, end)))
        return max(found)

    def seconds(variant):
        summary = context.run("strip", strip(*variant, SCHEMES[variant[1]], end))
        return {"seconds": summary["process_seconds"], "dofs": summary["dofs"]}

    times = interleaved(itertools.product(meshes, SCHEMES), context.pick(3, 1), seconds)
    rows = []
    for mesh in meshes:
        row = {"cells": "{}, {}, {} x {}".format(*mesh), "dofs": int(times[mesh, "Newmark"].median["dofs"])}
        for scheme in SCHEMES:
            sample = times[mesh, scheme]
            row.update({f"{scheme} time": sample.ratio["seconds"], f"{scheme} error": error(mesh, scheme),
                        f"{scheme} seconds": sample.median["seconds"]})
        rows.append(row)
    return rows


# The spatula: a number of hexahedra, or cells across and along it with one layer and one ring.
SPATULA = (("Enhanced", "Q1C2", 12, 120), ("Enhanced", "Q1C2", 8, 90), ("Enhanced", "Q1C2", 1500),
           ("linear", "Q1C1", 1500), ("linear", "Q1C2", 5000), ("quadratic", "Q2C2", 600), ("quadratic", "Q2C2", 8, 90))
REFERENCE = ("quadratic", "Q2C2", 16, 200)


def spatula(mesh, end):
    """Returns the settings of a run of the stiff spatula."""
    kind, contact, *size = mesh
    if len(size) == 1:
        shape = {"Target Cells": size[0]}
    else:
        shape = {"Core Cells": size[0], "Core Layers": 1, "Rings": 1, "Tip Rows": size[0] // 4, "Stations": size[1]}
    return [*(f"Mesh/Spatula/{name}={value}" for name, value in shape.items()), *cells(kind, contact, "Keratin"),
            f"{FINAL_TIME}={end}"]


def measure_spatula(context):
    """Runs each mesh once, past the largest force, and compares its force with that of a fine mesh."""
    end = context.pick(32, 8)
    fine = context.pick(REFERENCE, ("quadratic", "Q2C2", 600))
    context.run("spatula-stiff", spatula(fine, end), ranks=context.pick(2, 1), name="reference")
    rows = []
    for mesh in context.pick(SPATULA, SPATULA[1:2] + SPATULA[4:5]):
        summary = context.run("spatula-stiff", spatula(mesh, end))
        size = f"{summary['elements']:,}" if len(mesh) == 3 else "{2} across, {3} along".format(*mesh)
        seconds = summary["cpu_seconds"]
        rows.append({"cells": f"{mesh[0]}, {mesh[1]}, {size}", "dofs": summary["dofs"], "seconds": seconds,
                     "time": seconds / (rows[0]["seconds"] if rows else seconds),
                     "error": error_of_force(context, "run", "shaft end_z", (5, end))})
    return rows


# The peak force: cells along and across, four times finer along, so that several resolve the cohesive zone.
ORDER_MESHES = ((160, 2), (320, 4), (640, 8))
ORDER_CELLS = {"quadratic, Q2C2": ("quadratic", "Q2C2"), "Enhanced, Q1C4": ("Enhanced", "Q1C4"),
               "linear, Q1C1": ("linear", "Q1C1")}


def peak(force):
    """Returns the top of the parabola through the largest force and its neighbours."""
    k = int(np.argmax(force))
    if not 0 < k < len(force) - 1:
        raise Failure("the largest force is at an end of the run")
    before, largest, after = force[k - 1:k + 2]
    return float(largest + (after - before) ** 2 / (8 * (2 * largest - before - after)))


def limit(first, second, third):
    """Returns Richardson's extrapolation of the values of three meshes, each of half the size of the last."""
    ratio = (third - second) / (second - first)
    if not 0 < ratio < 1:
        raise Failure("the peak forces of quadratic cells do not converge")
    return third + (third - second) * ratio / (1 - ratio)


def measure_order(context):
    """Finds the peak force of each mesh. Rows are 0.05 L0 of displacement apart; the peak lies near 11 L0."""
    found = {}
    meshes = context.pick(ORDER_MESHES, ((80, 1), (160, 2), (320, 4)))
    for name, cell in ORDER_CELLS.items():
        for mesh in meshes:
            summary = context.run("strip", [
                bodies.divisions(*mesh), *cells(*cell, "Strip"), f"{SCHEME}=Static",
                f"{TIME_STEP}={context.pick(0.05, 0.1)}", f"{FINAL_TIME}=14", "Histories/Pull/Rate Ramp/Length=1"])
            force = results.Run(context.folder / "run").reaction("right_y")[2]
            found.setdefault(name, []).append((summary["dofs"], peak(force)))
    exact = limit(*(force for _, force in found["quadratic, Q2C2"]))
    rows = []
    for name, values in found.items():
        last = None
        for mesh, (dofs, force) in zip(meshes, values):
            error = force / exact - 1
            order = None if last is None else float(np.log2(abs(last / error)))
            rows.append({"cells": f"{name}, {mesh[0]} x {mesh[1]}", "error": error, "order": order, "dofs": dofs,
                         "force": force})
            last = error
    return rows


TABLES = [
    Table(name="elements-strip", page=PAGE, code=bodies.MECHANICS, minutes=3, measure=measure_strip, picture=PICTURE,
          columns=[Column("cells"), *(column for scheme, step in SCHEMES.items() for column in (
              Column(f"{scheme}, dt = {step:g}: time to the first row", "{:.2f}", f"{scheme} time"),
              Column("error", "{:.4f}", f"{scheme} error"))),
                   Column("degrees of freedom", "{:,}", "dofs"),
                   Column("s, Newmark", "{:.2f}", "Newmark seconds"), Column("s, Static", "{:.2f}", "Static seconds")]),
    Table(name="elements-spatula", page=PAGE, code=bodies.MECHANICS, minutes=7, measure=measure_spatula,
          why="a coarser reference would have the errors of the better meshes", picture=PICTURE,
          columns=[Column("cells"), Column("processor time to the first row", "{:.2f}", "time"),
                   Column("error", "{:.4f}"), Column("degrees of freedom", "{:,}", "dofs"),
                   Column("processor time, s", "{:.1f}", "seconds")]),
    Table(name="elements-order", page=PAGE, code=bodies.MECHANICS, minutes=1.5, measure=measure_order,
          columns=[Column("cells"), Column("relative error", "{:.1e}", "error"), Column("order", "{:.1f}"),
                   Column("degrees of freedom", "{:,}", "dofs"), Column("peak force, E0 L0", "{:.7f}", "force")]),
]
