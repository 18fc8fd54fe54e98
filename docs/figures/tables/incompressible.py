"""Cook's membrane and a twisted bar near Poisson's ratio 1/2: results, ripple of the pressure, Newton's iterations."""
import numpy
from netCDF4 import Dataset  # pylint: disable=no-name-in-module

from .. import bodies
from ..table import Column, Table

PAGE = "docs/results/elements.md"
RATIOS = (0.3, 0.4999, 0.49999)
DRAWING = "Mesh/Gmsh/Drawing"
TRIANGLE, QUADRILATERAL = ((0, 1), (1, 2), (2, 0)), ((0, 1), (1, 2), (2, 3), (3, 0))
# By mesh: its sides by corners, and whether it is structured and of triangles, for the drawing.
MESHES = {"structured quadrilaterals": (QUADRILATERAL, 1, 0), "structured triangles": (TRIANGLE, 1, 1),
          "gmsh's triangles": (TRIANGLE, 0, 1)}
SCENE, WIDTH, SHEAR = "meshes/cook.xml", 48, 80.194  # mm, MPa
STANDARD, MEAN = "Standard", "Mean Dilatation"
CELLS = (("structured quadrilaterals", 1, STANDARD), ("structured quadrilaterals", 1, MEAN),
         ("structured quadrilaterals", 2, STANDARD), ("structured quadrilaterals", 2, MEAN),
         ("structured triangles", 1, STANDARD), ("structured triangles", 2, STANDARD),
         ("structured triangles", 2, MEAN), ("gmsh's triangles", 2, STANDARD), ("gmsh's triangles", 2, MEAN))


def root_mean_square(values):
    return float(numpy.sqrt(numpy.mean(numpy.square(values))))


def invariants(path):
    """Returns tr(sigma) of the cells at the end, and their nodes."""
    with Dataset(path) as file:
        names = [bytes(name.compressed()).decode().strip("\0 ") for name in file.variables["name_elem_var"][:]]
        number = names.index("first_stress_invariant") + 1
        return (numpy.asarray(file.variables[f"vals_elem_var{number}eb1"][-1]),
                numpy.asarray(file.variables["connect1"][:]))


def ripple(path, sides):
    """Returns the root mean square of the jumps of tr(sigma) of cells with a common side, over that of tr(sigma)."""
    values, nodes = invariants(path)
    beside, jumps = {}, []
    for cell, own in enumerate(nodes):
        for side in sides:
            other = beside.setdefault(frozenset(own[list(side)].tolist()), cell)
            if other != cell:
                jumps.append(values[cell] - values[other])
    return root_mean_square(jumps) / root_mean_square(values)


def settings(mesh, order, formulation, ratio, divisions):
    """Returns the settings of a run. The shear modulus is the same for all ratios."""
    _, structured, triangles = MESHES[mesh]
    return [f"{DRAWING}/Constants/structured={structured}", f"{DRAWING}/Constants/triangles={triangles}",
            f"{DRAWING}/Constants/divisions={divisions // order}", f"{DRAWING}/Size={WIDTH / divisions * order} mm",
            f"Mesh/Cell Order={order}", f"Materials/Rubber/Element Formulation={formulation}",
            f"Materials/Rubber/Poisson's Ratio={ratio}",
            f"Materials/Rubber/Young's Modulus={2 * SHEAR * (1 + ratio)} MPa"]


def measure(context):
    """Runs each kind of cells at each ratio, and the last ratio without mixed steps, too."""
    rows = []
    for mesh, order, formulation in context.pick(CELLS, CELLS[:2]):
        row = {"mesh": mesh, "cells": f"{'linear' if order == 1 else 'quadratic'}, {formulation}"}
        for ratio in context.pick(RATIOS, RATIOS[:2]):
            own = settings(mesh, order, formulation, ratio, context.pick(16, 4))
            summary = context.run(SCENE, own, frames=True)
            row["dofs"] = summary["dofs"]
            row[f"tip {ratio}"] = context.history()["corner_uy"][-1]
            row[f"ripple {ratio}"] = ripple(context.folder / "run/fields.e", MESHES[mesh][0])
            row[f"iterations {ratio}"] = summary["newton_iterations"] / summary["steps"]
        plain = context.run(SCENE, [*own, "Nonlinear Solver/Mixed Steps=false"], allowed=(0, 3))
        row["plain"] = plain["newton_iterations"] / plain["steps"] if plain["status"] == "completed" else "fails"
        rows.append(row)
    return rows


# The twisted bar: constants of the drawing, order, formulation.
TETRAHEDRON = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))
HEXAHEDRON = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
SOLIDS = {"structured hexahedra": (HEXAHEDRON, 1, 0), "structured tetrahedra": (TETRAHEDRON, 1, 1),
          "gmsh's tetrahedra": (TETRAHEDRON, 0, 1)}
BAR = "meshes/bar.xml"
BARS = (("structured hexahedra", 2, STANDARD), ("structured hexahedra", 2, MEAN),
        ("structured tetrahedra", 2, STANDARD), ("structured tetrahedra", 2, MEAN),
        ("gmsh's tetrahedra", 2, STANDARD), ("gmsh's tetrahedra", 2, MEAN))


def measure_bar(context):
    """Twists the bar by a quarter of a turn in ten steps with each kind of cells at each ratio."""
    rows = []
    for mesh, order, formulation in context.pick(BARS, BARS[2:3]):
        sides, structured, tetrahedra = SOLIDS[mesh]
        divisions = context.pick(8, 2) // order
        row = {"mesh": mesh, "cells": f"{'linear' if order == 1 else 'quadratic'}, {formulation}"}
        for ratio in context.pick(RATIOS, RATIOS[:2]):
            summary = context.run(BAR, [
                f"{DRAWING}/Constants/structured={structured}", f"{DRAWING}/Constants/tetrahedra={tetrahedra}",
                f"{DRAWING}/Constants/divisions={divisions}", f"{DRAWING}/Size={1 / divisions} mm",
                f"Mesh/Cell Order={order}", f"Materials/Rubber/Element Formulation={formulation}",
                f"Materials/Rubber/Poisson's Ratio={ratio}", f"Materials/Rubber/Young's Modulus={2 * (1 + ratio)} MPa",
                "Time Integrator/Time Step Control/Time Step=0.1"], frames=True)
            row["dofs"] = summary["dofs"]
            row[f"moment {ratio}"] = context.history()["moment_Twist_z"][-1]
            row[f"pressure {ratio}"] = root_mean_square(invariants(context.folder / "run/fields.e")[0]) / 3
            row[f"ripple {ratio}"] = ripple(context.folder / "run/fields.e", sides)
            row[f"iterations {ratio}"] = summary["newton_iterations"] / summary["steps"]
        rows.append(row)
    return rows


def columns_of(titles):
    """Returns the columns of these titles, formats and keys, each at all ratios."""
    return [Column(f"{title} at {ratio}", form, f"{key} {ratio}") for title, form, key in titles for ratio in RATIOS]


RIPPLE, ITERATIONS = ("ripple", "{:.3f}", "ripple"), ("iterations a step", "{:.1f}", "iterations")
TABLES = [
    Table(name="elements-incompressible", page=PAGE, code=bodies.MECHANICS, minutes=1, measure=measure,
          columns=[Column("mesh"), Column("cells"), Column("degrees of freedom", "{:,}", "dofs"),
                   *columns_of((("deflection, mm", "{:.3f}", "tip"), RIPPLE, ITERATIONS)),
                   Column("without mixed steps", "{:.1f}", "plain")]),
    Table(name="elements-twist", page=PAGE, code=bodies.MECHANICS, minutes=5, measure=measure_bar,
          columns=[Column("mesh"), Column("cells"), Column("degrees of freedom", "{:,}", "dofs"),
                   *columns_of((("moment, N mm", "{:.4f}", "moment"), ("pressure, MPa", "{:.4f}", "pressure"), RIPPLE,
                                ITERATIONS))]),
]
