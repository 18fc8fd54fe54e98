"""The spatula: free vibration, peeling by scheme, and the full mesh before it peels."""
import sys

import numpy as np

from .. import bodies
from ..runs import FINAL_TIME, ROOT, SCHEME, interleaved, results
from ..table import Column, Table

PAGE = "docs/results/spatula.md"

DAMPINGS = [("Newmark", value) for value in ("0", "0.001", "0.004", "0.02", "0.1", "6")] + [
    ("Bathe", value) for value in ("0", "0.004")]


def measure_damping(context):
    """Lets the bent spatula go, with the script that also makes the runs of the pictures."""
    end, window = context.pick((250, (200, 250)), (10, (5, 10)))
    context.run_text("tests/bench/spatula_damping.sh", context.folder, 1500, context.program("ixos"),
                     "--set", f"{FINAL_TIME}={end}")
    rows = []
    for scheme, damping in DAMPINGS:
        history = context.history(f"{scheme}-{damping}")
        late = (history["time"] >= window[0]) & (history["time"] <= window[1])
        energy = history["total_energy"]
        rows.append({"scheme": {"Bathe": "Bathe Composite"}.get(scheme, scheme), "damping": damping,
                     "energy": float(energy[-1] / energy[0]), "deflection": float(np.abs(history["P_uz"][late]).max())})
    return rows


SCALE = 0.25  # of the full pad
SCHEMES = ("Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field")  # the first is the base


def measure_peeling(context):
    """Peels a pad of a quarter of the size with each scheme, once, until it is free.

    Its mesh is that of the cookbook: three faces are in the cohesive zone, so that the front moves smoothly."""
    sys.path.append(str(ROOT / "docs/cookbook"))
    import recipe  # pylint: disable=import-outside-toplevel  (it needs Matplotlib, which only this table does)
    study = recipe.study("spatula")
    shape = study.beam.LATE
    coarse = study.cohesive_zone(SCALE), study.MESHES[SCALE][1]  # one face in the cohesive zone
    settings = study.settings(shape, SCALE, mesh=context.pick(None, coarse))
    rows = []
    for scheme in context.pick(SCHEMES, SCHEMES[:1]):
        summary = context.run("spatula", [f"{path}={recipe.text(value)}"
                                          for path, value in {**settings, SCHEME: scheme}.items()])
        found = study.measured(results.Run(context.folder / "run"), SCALE, shape)
        seconds = summary["cpu_seconds"]
        rows.append({"scheme": scheme, "time": seconds / (rows[0]["seconds"] if rows else seconds),
                     "balance": float(found["balance"]), "Newton": float(found["iterations"]),
                     "first": float(found["first"][0]), "late": float(found["late"][0]), "free": float(found["free"]),
                     "seconds": seconds})
    return rows


SOLVERS = {"MUMPS in single precision (default)": [], "MueLu": bodies.iterative("MueLu", "Matrix-Free")}


def measure_speed(context):
    """Times the first steps of the full mesh, by solver and ranks."""
    scene, settings = bodies.spatula(context.pick(114414, 1500), 4)

    def numbers(variant):
        solver, ranks = variant
        summary = context.run(scene, settings + SOLVERS[solver], ranks)
        return bodies.per_iteration(summary) | {"step": summary["seconds_per_increment"]}

    default, multigrid = SOLVERS
    cases = context.pick([(default, 1), (default, 2)], [(default, 1)])
    samples = interleaved(cases, context.pick(2, 1), numbers, warm_up=False)
    once = {(multigrid, ranks): numbers((multigrid, ranks)) for ranks in context.pick((1, 2), (1,))}
    base = samples[default, 1].median
    rows = [{"solver": solver, "ranks": ranks, "time": sample.ratio["step"], **sample.median}
            for (solver, ranks), sample in samples.items()]
    return rows + [{"solver": solver, "ranks": ranks, "time": found["step"] / base["step"], **found}
                   for (solver, ranks), found in once.items()]


TABLES = [
    Table(name="spatula-damping", page=PAGE, code=(*bodies.MECHANICS, "xml/spatula-vibration.xml"), minutes=1.5,
          measure=measure_damping,
          columns=[Column("scheme"), Column("stiffness damping, T0", key="damping"),
                   Column("energy at 250 T0 to that at 0", "{:.3g}", "energy"),
                   Column("largest deflection of P from 200 to 250 T0, nm", "{:.3g}", "deflection")]),
    Table(name="spatula-peeling", page=PAGE, code=bodies.MECHANICS, minutes=2.5,
          measure=measure_peeling,
          columns=[Column("scheme"), Column("processor time to Newmark", "{:.2f}", "time"),
                   Column("error of the energy balance over the work", "{:.0e}", "balance"),
                   Column("Newton iterations a step", "{:.1f}", "Newton"),
                   Column("first peak, nN", "{:.2f}", "first"), Column("late peak, nN", "{:.2f}", "late"),
                   Column("free at a lift of, nm", "{:.0f}", "free"),
                   Column("processor time, s", "{:.1f}", "seconds")]),
    Table(name="spatula-speed", page=PAGE, code=bodies.MECHANICS, minutes=3,
          measure=measure_speed,
          columns=[Column("solver"), Column("ranks"), Column("time of a step to the first row", "{:.2f}", "time"),
                   *bodies.COLUMNS]),
]
