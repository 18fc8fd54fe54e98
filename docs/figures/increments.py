"""Rows of tables on the cost of an increment, scheme against scheme."""
from .runs import FINAL_TIME, SCHEME, interleaved
from .table import Column

INCREMENT_COLUMNS = [Column("scheme"), Column("an increment, to Newmark's", "{:.2f}"),
                     Column("an iteration, to Newmark's", "{:.2f}"), Column("iterations an increment", "{:.2f}"),
                     Column("ms an increment", "{:.3f}")]


SOLVER = "Linear Solver/Linear Solver Type"
BY_KLU = "Energy-Momentum with KLU"  # the solver of its unsymmetric matrices before Band had one


def settings_of(scheme):
    """Returns the settings of a scheme, or of one with a direct solver: "Energy-Momentum with KLU"."""
    name, _, solver = scheme.partition(" with ")
    return [f"{SCHEME}={name}", *([f"{SOLVER}=Direct", f"{SOLVER}s/Direct/Solver Type={solver}"] if solver else [])]


def measure(context, scene, end, schemes, repeats, settings=()):
    """Runs a scene to a time with schemes in turns. Returns a Sample by scheme; `end` is a full and a short time."""
    def figures(scheme):
        done = context.run(scene, [*settings, *settings_of(scheme), f"{FINAL_TIME}={context.pick(*end)}"])
        seconds, newton = done["wall_seconds"], done["newton_iterations"]
        found = {"increment": seconds / done["steps"], "iterations": newton / done["steps"]}
        if newton:  # an explicit scheme has none
            found["iteration"] = seconds / newton
        return found

    return interleaved(schemes, context.pick(repeats, 1), figures)


def increment_rows(samples):
    """Returns the rows of INCREMENT_COLUMNS."""
    return [{"scheme": scheme, "an increment, to Newmark's": sample.ratio["increment"],
             "an iteration, to Newmark's": sample.ratio.get("iteration"),
             "iterations an increment": sample.median["iterations"] or None,
             "ms an increment": 1e3 * sample.median["increment"]} for scheme, sample in samples.items()]
