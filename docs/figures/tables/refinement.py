"""Meshes that are finer at the contact: error against unknowns, beside meshes that are equally fine everywhere."""
from .. import bodies
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved, measures, results
from ..table import Column, Table

PAGE = "docs/results/elements.md"
PICTURE = "tests/bench/error_over_unknowns.py"


def region(name, levels, **where):
    """Returns the settings of a list of Mesh/Refine."""
    path = f"Mesh/Refine/{name}"
    return [f"{path}/Levels={levels}", *(f"{path}/{key.replace('_', ' ')}={value}" for key, value in where.items())]


# By scene: reaction, window of the error, settings of every run, uniform meshes (cells along and across), the reference,
# and refined ones: the coarse mesh and the levels at the contact.
SCENES = {
    "strip": ("right_y", (20, 120), [f"{SCHEME}=Static", f"{TIME_STEP}=1", f"{FINAL_TIME}=120",
                                     "Materials/Strip/Element Formulation=Enhanced",
                                     "Interactions/Wall/Contact Element=Q1C4"],
              ((80, 4), (160, 8), (320, 16)), (640, 32), ((80, 4, 1), (80, 4, 2), (160, 4, 1))),
    "jkr": ("top_y", (0, 2), [f"{TIME_STEP}=0.02"],
            ((46, 11), (92, 22), (184, 44)), (368, 88), ((46, 11, 1), (46, 11, 2), (46, 11, 3))),
}


def contact(scene, levels):
    """Returns the settings that refine a scene's mesh at the contact."""
    if scene == "strip":  # half a cell above the side: its row alone
        return region("Foot", levels, Side_Set="bottom", Distance=0.1)
    return region("Contact", levels, Lower="{0, 0}", Upper="{60, 0.5}")


def mesh(scene, along, across, levels=0):
    """Returns the settings of a mesh of a scene."""
    return [bodies.divisions(along, across), *(contact(scene, levels) if levels else [])]


def measure(context):
    """Compares the reaction of each mesh with that of the finest uniform one, in the same steps."""
    rows = []
    for scene, (reaction, window, settings, uniform, finest, refined) in SCENES.items():
        finest = context.pick(finest, uniform[-1])
        context.run(scene, [*settings, *mesh(scene, *finest)], name="reference")
        variants = [*context.pick(uniform, uniform[:2]), *context.pick(refined, refined[:1])]

        def seconds(variant):
            summary = context.run(scene, [*settings, *mesh(scene, *variant)])
            (_, *found), (_, *fine) = (results.Run(context.folder / name).reaction(reaction)
                                       for name in ("run", "reference"))
            return {"seconds": summary["wall_seconds"], "dofs": summary["dofs"],
                    "iteration": summary["wall_seconds"] / summary["newton_iterations"] / summary["dofs"],
                    "error": measures.deviation(*found, *fine, window)[1]}

        times = interleaved(variants, context.pick(3, 1), seconds)
        for variant in variants:
            found = times[variant]
            size = "{} x {}".format(*variant[:2])
            rows.append({"scene": scene, "mesh": f"{size}, {variant[2]} level{'s' * (variant[2] > 1)} at the contact"
                         if len(variant) == 3 else size, "dofs": int(found.median["dofs"]),
                         "error": found.median["error"], "time": found.ratio["seconds"],
                         "iteration": found.ratio["iteration"], "seconds": found.median["seconds"]})
    return rows


TABLES = [
    Table(name="elements-refinement", page=PAGE, code=bodies.MECHANICS, minutes=4, measure=measure, picture=PICTURE,
          columns=[Column("scene"), Column("mesh"), Column("degrees of freedom", "{:,}", "dofs"),
                   Column("error of the force", "{:.5f}", "error"), Column("time to the first row of the scene", "{:.2f}",
                                                                         "time"),
                   Column("iteration per unknown to that row", "{:.2f}", "iteration"),
                   Column("s", "{:.2f}", "seconds")]),
]
