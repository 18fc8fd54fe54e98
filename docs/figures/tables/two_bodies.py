"""Two bodies: what they keep, and what an increment costs."""
import math

import numpy as np

from .. import pair_scenes
from ..bodies import MECHANICS
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved
from ..table import Column, Table

PAGE = "docs/results/two-bodies.md"
WORK = 15 ** (1 / 3) * math.pi / 500  # of adhesion of the scenes' law, E0 L0
SPEED, RADIUS = 10.0, 5.0  # of each body in both scenes
CONTACT = "Interactions/Contact/"
POINTS = "Time Integrator/Average Vector Field/Interaction Points="
SPLINE = f"{CONTACT}Smoothing=Spline"

# Bodies, scheme, points in time, step [T0] and settings.
KEPT = (
    ("disks", "Energy-Momentum", None, 0.002, []),
    ("disks", "Average Vector Field", 8, 0.002, []),
    ("disks", "Average Vector Field", 32, 0.002, []),
    ("disks", "Average Vector Field", 8, 0.001, []),
    ("disks of splines", "Average Vector Field", 8, 0.002, [SPLINE]),
    ("disks", "Newmark", None, 0.002, []),
    ("balls, Cutoff 3", "Energy-Momentum", None, 0.002, []),
    ("balls, Cutoff 3", "Average Vector Field", 8, 0.002, []),
    ("balls of splines, Cutoff 3", "Average Vector Field", 8, 0.002, [SPLINE]),
    ("balls of splines, no Cutoff", "Average Vector Field", 8, 0.002, [SPLINE, f"{CONTACT}Cutoff=0"]),
)


def largest_change(history, names, size):
    """Returns the largest change of a vector since the first row, over a size."""
    columns = np.array([history[name] for name in names if name in history])
    return float(np.sqrt(((columns.T - columns[:, 0]) ** 2).sum(axis=1)).max() / size)


def measure_kept(context):
    """Runs the scenes of two bodies: how much energy and momenta change, of the sizes that they have."""
    rows = []
    for bodies, scheme, points, step, settings in context.pick(KEPT, KEPT[:2]):
        scene, end = ("two-spheres", 0.15) if bodies.startswith("balls") else ("two-balls", context.pick(2, 0.4))
        summary = context.run(scene, [f"{SCHEME}={scheme}", f"{TIME_STEP}={step}", f"{FINAL_TIME}={end}",
                                      *([f"{POINTS}{points}"] if points else []), *settings])
        history = context.history()
        momentum = 2 * history["kinetic_energy"][0] / SPEED  # of both bodies, without regard to direction
        rows.append({"bodies": bodies, "scheme": scheme + (f", {points} points in time" if points else ""),
                     "energy": summary["max_energy_error"] / WORK,
                     "linear": largest_change(history, [f"linear_momentum_{axis}" for axis in "xyz"], momentum),
                     "angular": largest_change(history, [f"angular_momentum_{axis}" for axis in "xyz"],
                                               RADIUS * momentum), "step": step, "steps": summary["steps"]})
    return rows


PASSES = {"One, 5 points": [], "One, 24 points": [f"{CONTACT}Surface Points=24"],
          "Two, 24 points": [f"{CONTACT}Passes=Two", f"{CONTACT}Surface Points=24"],
          "Double Integral, 8 points": [f"{CONTACT}Passes=Double Integral", f"{CONTACT}Surface Points=8"],
          "Double Integral, 24 points": [f"{CONTACT}Passes=Double Integral", f"{CONTACT}Surface Points=24"],
          "One, 5 points, splines": [SPLINE],
          "One, 5 points, friction": [f"{CONTACT}Friction/{setting}" for setting in (
              "Type=Extended Amontons", "Coefficient=0.5")]}


def measure_passes(context):
    """Times the first increments of two disks, in which they meet."""
    errors = {}

    def numbers(name):
        summary = context.run("two-balls", [f"{FINAL_TIME}=0.1", *PASSES[name]])
        errors[name] = summary["max_energy_error"] / WORK
        return {"seconds": summary["seconds_per_increment"], "Newton": summary["newton_iterations"] / summary["steps"]}

    names = context.pick(list(PASSES), list(PASSES)[:3])
    samples = interleaved(names, context.pick(3, 1), numbers)
    return [{"passes": name, "time": sample.ratio["seconds"], "Newton": sample.median["Newton"],
             "energy": None if "friction" in name else errors[name], "ms": 1e3 * sample.median["seconds"]}
            for name, sample in samples.items()]


PHASES = ("residual", "tangent", "linear solve")
CELLS = ((17, 9), (12, 6))  # divisions of a ball's core and its rings


def measure_cost(context):
    """Times increments after the first one: the difference of two runs. One ball has as many cells as two."""
    cases = ((CELLS[0], 1), (CELLS[0], 2), (CELLS[1], 1))
    return [row for cells, ranks in context.pick(cases, (((5, 2), 1),))
            for row in compare_bodies(context, cells, ranks, context.pick(5, 1))]


def compare_bodies(context, cells, ranks, count):
    """Returns the rows of one ball and of two on so many ranks. count: increments that are timed."""
    def numbers(name):
        first, last = (context.run(*pair_scenes.body(context, name, cells, steps), ranks) for steps in (1, 1 + count))
        newton = last["newton_iterations"] - first["newton_iterations"]
        seconds = {phase: last["seconds"].get(phase, 0) - first["seconds"].get(phase, 0) for phase in PHASES}
        whole = last["wall_seconds"] - first["wall_seconds"]
        return {"increment": whole / count, "iteration": whole / newton, "Newton": newton / count, "dofs": last["dofs"],
                **{phase: value / newton for phase, value in seconds.items()}}

    samples = interleaved(pair_scenes.SCENES, context.pick(2, 1), numbers, warm_up=False)
    return [{"bodies": name, "ranks": ranks, **sample.median, "dofs": int(sample.median["dofs"]),
             "increment ratio": sample.ratio["increment"], "iteration ratio": sample.ratio["iteration"]}
            for name, sample in samples.items()]


TABLES = [
    Table(name="two-bodies-kept", page=PAGE, code=MECHANICS, minutes=2.5, measure=measure_kept,
          columns=[Column("bodies"), Column("scheme"), Column("energy over W", "{:.0e}", "energy"),
                   Column("linear momentum", "{:.0e}", "linear"), Column("angular momentum", "{:.0e}", "angular"),
                   Column("dt, T0", "{:g}", "step"), Column("steps", "{:,}")]),
    Table(name="two-bodies-passes", page=PAGE, code=MECHANICS, minutes=1, measure=measure_passes,
          columns=[Column("passes"), Column("time of an increment to the first row", "{:.2f}", "time"),
                   Column("Newton iterations a step", "{:.2f}", "Newton"),
                   Column("error of the energy over W", "{:.0e}", "energy"),
                   Column("ms an increment", "{:.1f}", "ms")]),
    Table(name="two-bodies-cost", page=PAGE, code=(*MECHANICS, "docs/figures/pair_scenes.py"), minutes=2,
          measure=measure_cost,
          columns=[Column("bodies"), Column("an increment to one ball", "{:.2f}", "increment ratio"),
                   Column("a Newton iteration to one ball", "{:.2f}", "iteration ratio"),
                   Column("degrees of freedom", "{:,}", "dofs"), Column("ranks"),
                   Column("Newton iterations a step", "{:.1f}", "Newton"),
                   Column("s an increment", "{:.3f}", "increment"),
                   *(Column(f"{phase}, s an iteration", "{:.3g}", phase) for phase in PHASES)]),
]
