"""Rows of tables on the cost of an increment: scheme against scheme, and the phases of a Newton iteration."""
from .runs import FINAL_TIME, SCHEME, interleaved
from .table import Column

CODE = ("lib/time", "lib/solve", "lib/model", "lib/term", "lib/element", "lib/material", "lib/interaction")
PHASES = ("residual", "tangent", "factorization", "linear solve", "output")
HEADS = {"factorization": "factorisation", "linear solve": "solve"}
INCREMENT_COLUMNS = [Column("scheme"), Column("an increment, to Newmark's", "{:.2f}"),
                     Column("an iteration, to Newmark's", "{:.2f}"), Column("iterations an increment", "{:.2f}"),
                     Column("ms an increment", "{:.3f}")]
PHASE_COLUMNS = [Column("scheme"), *(Column(HEADS.get(name, name), "{:.0%}", name) for name in PHASES),
                 Column("the rest", "{:.0%}"), Column("µs an iteration", "{:.1f}")]


def measure(context, scene, end, schemes, repeats, settings=()):
    """Runs a scene to a time with schemes in turns. Returns a Sample by scheme; `end` is a full and a short time."""
    def figures(scheme):
        done = context.run(scene, [*settings, f"{SCHEME}={scheme}", f"{FINAL_TIME}={context.pick(*end)}"])
        seconds, newton = done["wall_seconds"], done["newton_iterations"]
        found = {"increment": seconds / done["steps"], "iterations": newton / done["steps"]}
        if newton:  # an explicit scheme has none
            found["iteration"] = seconds / newton
            found.update((phase, done["seconds"][phase] / seconds) for phase in PHASES)
        return found

    return interleaved(schemes, context.pick(repeats, 1), figures)


def increment_rows(samples):
    """Returns the rows of INCREMENT_COLUMNS."""
    return [{"scheme": scheme, "an increment, to Newmark's": sample.ratio["increment"],
             "an iteration, to Newmark's": sample.ratio.get("iteration"),
             "iterations an increment": sample.median["iterations"] or None,
             "ms an increment": 1e3 * sample.median["increment"]} for scheme, sample in samples.items()]


def phase_rows(samples):
    """Returns the rows of PHASE_COLUMNS: shares of the time of an iteration."""
    return [{"scheme": scheme, **{phase: sample.median[phase] for phase in PHASES},
             "the rest": 1 - sum(sample.median[phase] for phase in PHASES),
             "µs an iteration": 1e6 * sample.median["iteration"]} for scheme, sample in samples.items()]
