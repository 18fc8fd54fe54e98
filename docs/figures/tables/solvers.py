"""Linear solvers, products with the tangent, and the first guess of Newton's method."""
import itertools
import re

from .. import bodies
from ..bodies import MECHANICS, divisions, iterative
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved, markdown_rows
from ..table import Column, Table

PAGE = "docs/results/solvers.md"
QUADRATIC = ["Mesh/Cell Order=2", "Interactions/Wall/Contact Element=Q2C2"]

# Slender bodies, which take Band by default, and the best other choice: to 2,000 degrees of freedom a factorisation of
# each tangent, beyond CG with a kept one.
CHOLMOD = ["Linear Solver/Linear Solver Type=Direct", "Linear Solver/Linear Solver Types/Direct/Solver Type=CHOLMOD"]
KEPT = iterative("Direct", solver="CHOLMOD")
SLENDER = {
    "strip, Static, 160 x 2 quadratic": ("strip", KEPT, [
        f"{SCHEME}=Static", divisions(160, 2), *QUADRATIC, f"{TIME_STEP}=16", f"{FINAL_TIME}=120"]),
    "strip, Newmark, 160 x 4": ("strip", CHOLMOD, [
        f"{SCHEME}=Newmark", divisions(160, 4), "Interactions/Wall/Contact Element=Q1C1", f"{TIME_STEP}=4",
        f"{FINAL_TIME}=120"]),
    "film-peel": ("film-peel", KEPT, [f"{FINAL_TIME}=20"]),
    "waviness": ("waviness", KEPT, [f"{FINAL_TIME}=0.25"]),
    "hairpin": ("hairpin", CHOLMOD, [f"{FINAL_TIME}=0.08"]),
    "two-spheres": ("two-spheres", CHOLMOD, [f"{FINAL_TIME}=0.04"]),
    "block-on-wall, 80 x 4 x 4 cells": ("block-on-wall", KEPT, bodies.block((80, 4, 4), 8)[1]),
}


def measure_band(context):
    """Compares Band with the other choice, scene by scene."""
    return [compare_band(context, name, *SLENDER[name]) for name in context.pick(list(SLENDER), list(SLENDER)[:3])]


def compare_band(context, name, scene, other, settings):
    """Returns the row of a scene."""
    def numbers(solver):
        summary = context.run(scene, settings + (other if solver == "other" else []))
        return {"seconds": summary["wall_seconds"], "dofs": summary["dofs"]}

    samples = interleaved(("other", "Band"), context.pick(3, 1), numbers, warm_up=False)
    return {"scene": name, "time": samples["Band"].ratio["seconds"],
            "other": "CHOLMOD" if other == CHOLMOD else "CG, kept CHOLMOD",
            "dofs": int(samples["Band"].median["dofs"]), "s other": samples["other"].median["seconds"],
            "s Band": samples["Band"].median["seconds"]}


BLOCK_STEPS = (0.5, 0.02, 0.005, 0.001)  # T0; a pressure wave crosses some 1,500 cells in 1 T0
OTHERS = ("Two-Level", "MueLu", "Chebyshev")
PRECONDITIONERS = {"Automatic": [], **{name: iterative(name) for name in OTHERS}}


def measure_block(context):
    """Times iterations of the block on the wall by step and preconditioner."""
    return [compare_preconditioners(context, step) for step in context.pick(BLOCK_STEPS, BLOCK_STEPS[1:2])]


def compare_preconditioners(context, step):
    """Returns the row of a step."""
    scene, settings = bodies.block([context.pick(32, 12)] * 3, context.pick(4, 2), step)

    def numbers(name):
        return bodies.per_iteration(context.run(scene, settings + PRECONDITIONERS[name]))

    samples = interleaved(PRECONDITIONERS, context.pick(2, 1), numbers, warm_up=False)
    automatic = samples["Automatic"].median
    return {"step": step, "crossings": 1500 * step, "seconds": automatic["seconds"],
            **{name: samples[name].ratio["seconds"] for name in OTHERS},
            **{f"CG {name}": samples[name].median["CG"] for name in OTHERS},
            **{f"memory {name}": samples[name].median["memory"] for name in OTHERS}}


# Cells along the edges of a block, its order, and its lengths where cells are no cubes.
SMALL = (((4, 4, 4), 2, None), ((8, 8, 8), 2, None), ((8, 8, 8), 1, None), ((20, 20, 20), 1, None),
         ((44, 12, 12), 1, None), ((16, 16, 16), 1, (16, 16, 1.6)), ((16, 16, 16), 1, (16, 16, 160)))


def small_name(cells, order, lengths):
    """Returns a block in words."""
    kind = "quadratic" if order == 2 else "linear"
    aspect = lengths and max(lengths[2] / cells[2], cells[2] / lengths[2])
    form = lengths and ("tall" if lengths[2] > cells[2] else "flat")
    return f"{cells[0]} x {cells[1]} x {cells[2]} {kind}" + (f", {form}, aspect ratio {aspect:g}" if lengths else "")


def measure_small(context):
    """Compares the cycle of two levels with a factorisation, in whole runs of small blocks."""
    return [compare_small(context, *block) for block in context.pick(SMALL, SMALL[2:3])]


def compare_small(context, cells, order, lengths):
    """Returns the row of a block."""
    settings = [divisions(*cells), f"Mesh/Box/Lengths={{{', '.join(map(str, lengths or cells))}}}",
                *(QUADRATIC if order == 2 else [])]

    def numbers(preconditioner):
        summary = context.run("block-on-wall", settings + iterative(preconditioner))
        return {"seconds": summary["cpu_seconds"], "dofs": summary["dofs"]}

    samples = interleaved(("Direct", "Two-Level"), context.pick(2, 1), numbers, warm_up=False)
    return {"cells": small_name(cells, order, lengths), "time": samples["Two-Level"].ratio["seconds"],
            "dofs": int(samples["Direct"].median["dofs"]), "s Direct": samples["Direct"].median["seconds"],
            "s Two-Level": samples["Two-Level"].median["seconds"]}


def measure_static(context):
    """Solves the elasticity of a cube with MueLu and with two levels, in turns within the program."""
    found = {}
    for row in markdown_rows(context.run_text("static_solve", *context.pick((14, 48), (8,)), "x2", "Hex8", "Hex27", "Tet10")):
        cells, way = f"{row['']} {row['cells']}", row["preconditioner"]
        found.setdefault(cells, {"cells": cells}).update({
            "dofs": int(row["degrees of freedom"]), "error": float(row["error"]), f"CG {way}": int(row["CG"]),
            f"s {way}": float(row["total, s"])})
    for entry in found.values():
        entry["time"] = entry["s Two-Level"] / entry["s MueLu, assembled"]
    return list(found.values())


# Cells along an edge, ranks, rounds.
PRODUCTS = ((16, 1, 400), (48, 1, 40), (48, 2, 40))
CELLS = ("Hex8", "Hex27", "Tet10", "Tet15")
WAYS = ("matrix-free", "matrix-free, without mass", "matrix-free, single precision", "matrix-free, stiffness damping",
        "matrix-free, four points in time", "ghosts alone")


def measure_products(context):
    """Times products with the tangent of a block in turns within the program, for each type of cells."""
    rows = []
    for kind, (edge, ranks, rounds) in itertools.product(CELLS, context.pick(PRODUCTS, ((16, 1, 20),))):
        launcher = ["mpirun", "-np", ranks] if ranks > 1 else []
        text = context.execute([*launcher, context.program("product_times"), edge, rounds, kind]).output
        medians = {row["W x"]: float(row["median, ms"]) for row in markdown_rows(text)}
        rows.append({"cells": kind, "ranks": ranks, "dofs": int(re.search(r"(\d+) degrees of freedom", text)[1]),
                     **{name: medians[name] / medians["matrix"] for name in WAYS},
                     "ms matrix": medians["matrix"], "ms matrix-free": medians["matrix-free"]})
    return rows


def measure_ties(context):
    """Times the works of a tangent for each unknown, with and without ties, in turns within the program."""
    text = context.run_text("tie_times", *context.pick((30, 20), (8, 2)))
    numbers = re.compile(r"[0-9.]+")  # each dimension has a table, with a head of its own
    return [{"work": row["for each unknown"], "ns": float(row["without ties, ns"]),
             "hanging": float(row["hanging nodes, ratio"]), "tied": float(row["tied surfaces, ratio"])}
            for row in markdown_rows(text) if numbers.fullmatch(row["without ties, ns"])]


# Scene and settings of runs that start Newton's method from two guesses.
FRICTION = ["Interactions/Wall/Friction/Type=Extended Amontons", "Interactions/Wall/Friction/Coefficient=0.3"]
STARTS = {"strip": ("strip", [f"{FINAL_TIME}=40"]), "strip, friction": ("strip", [f"{FINAL_TIME}=40", *FRICTION]),
          "two-balls": ("two-balls", [f"{FINAL_TIME}=1"]),
          "spatula-stiff, 1,516 cells": ("spatula-stiff", ["Mesh/Spatula/Target Cells=1500", f"{FINAL_TIME}=45"])}
GUESSES = ("Nearest", "Last Displacement")


def measure_starts(context):
    """Counts Newton iterations from two guesses. Counts do not depend on the machine."""
    rows = []
    for name, (scene, settings) in itertools.islice(STARTS.items(), context.pick(None, 1)):
        row = {"scene": name}
        for guess in GUESSES:
            summary = context.run(scene, [*settings, f"Time Integrator/Predictor={guess}"])
            row[guess] = summary["newton_iterations"] / summary["steps"]
        rows.append(row | {"ratio": row["Nearest"] / row["Last Displacement"]})
    return rows


TABLES = [
    Table(name="solvers-band", page=PAGE, code=MECHANICS, minutes=1.5, measure=measure_band,
          columns=[Column("scene"), Column("Band to the other", "{:.2f}", "time"), Column("the other", key="other"),
                   Column("degrees of freedom", "{:,}", "dofs"), Column("s, the other", "{:.3f}", "s other"),
                   Column("s, Band", "{:.3f}", "s Band")]),
    Table(name="solvers-block", page=PAGE, code=MECHANICS, minutes=2, measure=measure_block,
          columns=[Column("dt, T0", "{:g}", "step"), Column("cells that a pressure wave crosses", "{:g}", "crossings"),
                   *(Column(f"{name} to Automatic", "{:.2f}", name) for name in OTHERS),
                   *(Column(f"CG iterations, {name}", "{:.1f}", f"CG {name}") for name in OTHERS),
                   *(Column(f"GB, {name}", "{:.2f}", f"memory {name}") for name in OTHERS),
                   Column("s an iteration, Automatic", "{:.3f}", "seconds")]),
    Table(name="solvers-small", page=PAGE, code=MECHANICS, minutes=1.5, measure=measure_small,
          columns=[Column("cells"), Column("Two-Level to Direct", "{:.2f}", "time"),
                   Column("degrees of freedom", "{:,}", "dofs"), Column("s, Direct", "{:.2f}", "s Direct"),
                   Column("s, Two-Level", "{:.2f}", "s Two-Level")]),
    Table(name="solvers-static", page=PAGE, code=(*MECHANICS, "tests/bench/static_solve.cpp"), minutes=1,
          needs=("static_solve",), measure=measure_static,
          columns=[Column("cells"), Column("Two-Level to MueLu", "{:.2f}", "time"),
                   Column("CG, Two-Level", key="CG Two-Level"), Column("CG, MueLu", key="CG MueLu, assembled"),
                   Column("error in L2", "{:.1e}", "error"), Column("degrees of freedom", "{:,}", "dofs"),
                   Column("s, Two-Level", "{:.3f}", "s Two-Level"),
                   Column("s, MueLu", "{:.3f}", "s MueLu, assembled")]),
    Table(name="solvers-products", page=PAGE, code=(*MECHANICS, "tests/bench/product_times.cpp"), minutes=1,
          needs=("product_times",), measure=measure_products,
          columns=[Column("cells"), Column("unknowns", "{:,}", "dofs"), Column("ranks"),
                   *(Column(name, "{:.2f}") for name in WAYS), Column("ms, matrix", "{:.2f}", "ms matrix"),
                   Column("ms, matrix-free", "{:.2f}", "ms matrix-free")]),
    Table(name="solvers-ties", page=PAGE, code=(*MECHANICS, "tests/bench/tie_times.cpp"), minutes=1,
          needs=("tie_times",), measure=measure_ties,
          columns=[Column("work, for each unknown", key="work"), Column("hanging nodes", "{:.2f}", "hanging"),
                   Column("tied surfaces", "{:.2f}", "tied"), Column("ns without ties", "{:.0f}", "ns")]),
    Table(name="solvers-start", page=PAGE, code=MECHANICS, minutes=1.2, measure=measure_starts,
          columns=[Column("scene"), Column("Nearest to Last Displacement", "{:.2f}", "ratio"),
                   *(Column(f"iterations a step, {guess}", "{:.2f}", guess) for guess in GUESSES)]),
]
