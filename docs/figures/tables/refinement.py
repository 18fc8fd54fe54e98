"""Meshes that are finer at the contact: error against unknowns, beside meshes that are equally fine everywhere."""
from .. import bodies
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved, measures, results
from ..table import Column, Table

PAGE = "docs/results/elements.md"
PICTURE = "tests/bench/error_over_unknowns.py"
FOLLOWING_PICTURE = "tests/bench/error_of_following.py"


def region(name, levels, **where):
    """Returns the settings of a list of Mesh/Refine."""
    path = f"Mesh/Refine/{name}"
    return [f"{path}/Levels={levels}", *(f"{path}/{key.replace('_', ' ')}={value}" for key, value in where.items())]


STRIP = [f"{SCHEME}=Static", f"{TIME_STEP}=1", f"{FINAL_TIME}=120", "Materials/Strip/Element Formulation=Enhanced",
         "Interactions/Wall/Contact Element=Q1C4"]
# The sphere of xml/jkr.xml from equal cells, which its map does not stretch.
SPHERE = [f"{TIME_STEP}=0.02", "Mesh/Box/Lengths={400, 400}", "Mesh/Map/X=x", "Mesh/Map/Y=2.2547093 + y + x^2/2000"]
# By title: scene, reaction, window of the error, settings of every run, uniform meshes (cells along and across), the
# reference, and refined ones. Behind the cells of a mesh: the levels at the contact, then those of a place around it.
SCENES = {
    "strip": ("strip", "right_y", (20, 120), STRIP, ((80, 4), (160, 8), (320, 16)), (640, 32),
              ((80, 4, 1), (80, 4, 2), (160, 4, 1))),
    "jkr": ("jkr", "top_y", (0, 2), [f"{TIME_STEP}=0.02"], ((46, 11), (92, 22), (184, 44)), (368, 88),
            ((46, 11, 1), (46, 11, 2), (46, 11, 3))),
    "jkr of equal cells": ("jkr", "top_y", (0, 2), SPHERE, ((25, 25), (50, 50), (100, 100)), (100, 100, 4, 2),
                           ((25, 25, 2), (25, 25, 3, 2), (50, 50, 3, 1), (50, 50, 4, 2))),
}


def contact(title, levels, around):
    """Returns the settings that refine a scene's mesh at the contact."""
    if title == "strip":  # half a cell above the side: its row alone
        return region("Foot", levels, Side_Set="bottom", Distance=0.1)
    if title == "jkr":
        return region("Contact", levels, Lower="{0, 0}", Upper="{60, 0.5}")
    own = region("Contact", levels, Lower="{0, 0}", Upper="{60, 4}")
    return own + (region("Around", around, Lower="{0, 0}", Upper="{120, 80}") if around else [])


def mesh(title, along, across, levels=0, around=0):
    """Returns the settings of a mesh of a scene."""
    return [bodies.divisions(along, across), *(contact(title, levels, around) if levels else [])]


def in_words(along, across, levels=0, around=0):
    """Returns a mesh in words."""
    words = f"{along} x {across}"
    if levels:
        words += f", {levels} level{'s' * (levels > 1)} at the contact"
    return words + (f", {around} around it" if around else "")


def measure(context):
    """Compares the reaction of each mesh with that of the finest uniform one, in the same steps."""
    rows = []
    for title, (scene, reaction, window, settings, uniform, finest, refined) in SCENES.items():
        finest = context.pick(finest, uniform[-1])
        context.run(scene, [*settings, *mesh(title, *finest)], name="reference")
        variants = [*context.pick(uniform, uniform[:2]), *context.pick(refined, refined[:1])]

        def seconds(variant):
            summary = context.run(scene, [*settings, *mesh(title, *variant)])
            (_, *found), (_, *fine) = (results.Run(context.folder / name).reaction(reaction)
                                       for name in ("run", "reference"))
            return {"seconds": summary["wall_seconds"], "dofs": summary["dofs"],
                    "iteration": summary["wall_seconds"] / summary["newton_iterations"] / summary["dofs"],
                    "error": measures.deviation(*found, *fine, window)[1]}

        times = interleaved(variants, context.pick(3, 1), seconds)
        for variant in variants:
            found = times[variant]
            rows.append({"scene": title, "mesh": in_words(*variant), "dofs": int(found.median["dofs"]),
                         "error": found.median["error"], "time": found.ratio["seconds"],
                         "iteration": found.ratio["iteration"], "seconds": found.median["seconds"]})
    return rows


# Meshes of the strip that follows its front, with those that are fine everywhere: cells along and across, levels, part.
FOLLOWING = ((320, 8, 0, 0), (160, 4, 0, 0), (120, 2, 0, 0), (80, 2, 2, 0.25), (80, 2, 2, 0.125), (80, 2, 3, 0.125))


def following(along, across, levels, part):
    """Returns the settings of a mesh."""
    return [bodies.divisions(along, across), f"Mesh/Adapt/Levels={levels}",
            *([f"Mesh/Adapt/Part={part}"] if levels else []), "Output/Fields Time Interval=0"]


def measure_following(context):
    """Compares the strip on each mesh with that on the mesh that is as fine everywhere."""
    rows, variants = [], context.pick(FOLLOWING, FOLLOWING[2:4])
    base = None
    for variant in variants:
        summary = context.run("strip-front", following(*variant))
        run = results.Run(context.folder / "run")
        _, *force = run.reaction("right_y")
        peak = max(own for time, own in zip(*force) if 20 <= time <= 100)
        found = {"peak": peak, "release": summary["contacts"]["Wall"]["released"], "seconds": summary["wall_seconds"],
                 "end": summary["end_time"], "force": force}
        base = base or found
        changes = summary.get("mesh_changes", {})
        along, across, levels, part = variant
        rows.append({"mesh": f"{along} x {across}" + (f", up to {levels} levels, Part {part}" if levels else ""),
                     "mean": changes.get("mean_dofs", summary["dofs"]), "most": changes.get("most_dofs", summary["dofs"]),
                     "changes": changes.get("count", 0), "peak": peak / base["peak"] - 1,
                     "release": (found["release"] - base["release"]) / base["end"],
                     "error": measures.deviation(*force, *base["force"], (20, 120))[1],
                     "time": found["seconds"] / base["seconds"], "seconds": found["seconds"]})
    return rows


# Meshes of the sphere of xml/sphere-front.xml: cells along and across, levels. The first one is the reference.
SPHERES = ((12, 6, 2), (24, 12, 0), (16, 8, 0), (12, 6, 0), (8, 4, 0), (4, 2, 2), (6, 3, 2), (8, 4, 1), (8, 4, 2))


def sphere(along, up, levels):
    """Returns the settings of a mesh."""
    return [f"Mesh/Box/Divisions={{{along}, {along}, {up}}}", f"Mesh/Adapt/Levels={levels}", "Mesh/Adapt/Budget=1",
            "Output/Fields Time Interval=0", "Output/Checkpoint/Keep=0"]


def measure_sphere(context):
    """Compares the force of the sphere on each mesh with that on the first one."""
    rows, finest = [], None
    for along, up, levels in context.pick(SPHERES, SPHERES[4:6]):
        summary = context.run("sphere-front", sphere(along, up, levels))
        _, *force = results.Run(context.folder / "run").reaction("top_z")
        finest = finest or force
        changes = summary.get("mesh_changes", {})
        rows.append({"mesh": f"{along} x {along} x {up}" + (f", up to {levels} level{'s' * (levels > 1)}" if levels else ""),
                     "mean": changes.get("mean_dofs", summary["dofs"]), "changes": changes.get("count", 0),
                     "error": measures.deviation(*force, *finest, (0, 2))[1],
                     "linear": summary["linear_iterations"] / summary["newton_iterations"],
                     "newton": summary["newton_iterations"], "seconds": summary["wall_seconds"]})
    uniform = next((row for row in rows if "level" not in row["mesh"]), rows[0])
    for row in rows:
        row["time"] = row["seconds"] / uniform["seconds"]
    return rows


TABLES = [
    Table(name="elements-sphere", page=PAGE, code=(*bodies.MECHANICS, "lib/adapt", "lib/run", "xml/sphere-front.xml"),
          minutes=6, why="the mesh that is equally fine everywhere and as good takes two minutes",
          measure=measure_sphere, picture=FOLLOWING_PICTURE,
          columns=[Column("mesh"), Column("mean degrees of freedom", "{:,.0f}", "mean"),
                   Column("changes of the mesh", "{:,}", "changes"), Column("error of the force", "{:.4f}", "error"),
                   Column("iterations of Newton's method", "{:,}", "newton"),
                   Column("of CG for each", "{:.1f}", "linear"), Column("time", "{:.2f}", "time"),
                   Column("s", "{:.1f}", "seconds")]),
    Table(name="elements-front", page=PAGE, code=(*bodies.MECHANICS, "lib/adapt", "lib/run", "xml/strip-front.xml"),
          minutes=2, measure=measure_following, picture=FOLLOWING_PICTURE,
          columns=[Column("mesh"), Column("mean degrees of freedom", "{:,.0f}", "mean"),
                   Column("at most", "{:,}", "most"), Column("changes of the mesh", "{:,}", "changes"),
                   Column("peak", "{:+.4f}", "peak"), Column("release", "{:+.4f}", "release"),
                   Column("error of the force", "{:.4f}", "error"), Column("time", "{:.2f}", "time"),
                   Column("s", "{:.1f}", "seconds")]),
    Table(name="elements-refinement", page=PAGE, code=bodies.MECHANICS, minutes=5, measure=measure, picture=PICTURE,
          columns=[Column("scene"), Column("mesh"), Column("degrees of freedom", "{:,}", "dofs"),
                   Column("error of the force", "{:.5f}", "error"), Column("time to the first row of the scene", "{:.2f}",
                                                                         "time"),
                   Column("iteration per unknown to that row", "{:.2f}", "iteration"),
                   Column("s", "{:.2f}", "seconds")]),
]
