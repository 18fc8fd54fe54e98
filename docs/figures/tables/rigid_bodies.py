"""Measures the cost of a rigid body."""
from ..bodies import MECHANICS
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved
from ..table import Column, Table

PAGE = "docs/results/rigid-bodies.md"
# Scene, scheme, end of a measurement and of a trial, time step, unknowns of the wall. The strip's steps are long enough
# for an iteration or more in each stage.
CASES = (("ball", "Average Vector Field", (1.4, 0.1), 0.01, 3), ("ball", "Energy-Momentum", (1.4, 0.1), 0.01, 3),
         ("ball", "Newmark", (1.4, 0.1), 0.01, 3), ("strip", "Gautam-Sauer Composite", (30, 2), 0.5, 3),
         ("strip", "Energy-Momentum", (30, 2), 0.5, 3), ("spatula", "Gautam-Sauer Composite", (1, 0.5), 0.5, 6))
CARRIED = "belongs to a body"


def wall(unknowns):
    """Returns the settings by which the wall belongs to a body so heavy that it hardly moves."""
    inertia = "{1e9}" if unknowns == 3 else "{1e9, 1e9, 1e9}"
    return ["Rigid Bodies/Wall/Mass=1e9", f"Rigid Bodies/Wall/Inertia={inertia}",
            "Interactions/Wall/Rigid Body=Wall"]


def measure_cost(context):
    """Runs scenes whose wall rests, and belongs to a free body, in turns."""
    rows = []
    for scene, scheme, end, step, unknowns in context.pick(CASES, CASES[:2]):
        def figures(variant):
            done = context.run(scene, [f"{SCHEME}={scheme}", f"{FINAL_TIME}={context.pick(*end)}", f"{TIME_STEP}={step}",
                                       *(wall(unknowns) if variant == CARRIED else [])])
            return {"iteration": done["wall_seconds"] / done["newton_iterations"],
                    "iterations": done["newton_iterations"] / done["steps"]}

        sample = interleaved(["rests", CARRIED], context.pick(3 if scene == "spatula" else 5, 1), figures)[CARRIED]
        rows.append({"scene": scene, "scheme": scheme, "unknowns of the body": unknowns,
                     "an iteration, to that without": sample.ratio["iteration"],
                     "iterations a step, to those without": sample.ratio["iterations"]})
    return rows


TABLES = [
    Table(name="rigid-cost", page=PAGE, code=(*MECHANICS, "lib/rigid", "lib/solve/bordered"), minutes=5,
          columns=[Column("scene"), Column("scheme"), Column("unknowns of the body", "{:d}"),
                   Column("an iteration, to that without", "{:.2f}"),
                   Column("iterations a step, to those without", "{:.2f}")], measure=measure_cost),
]
