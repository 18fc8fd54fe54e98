"""The errors that `ixos --accuracy` reports, against closed forms and much shorter fixed steps, and what it costs."""
import math

import numpy as np

from ..runs import FINAL_TIME, TIME_STEP
from ..table import Column, Table

RAMP = "Histories/Pull/Rate Ramp/Length"
OSCILLATOR = {"final P_ux": 0.1 / math.sqrt(3) * math.sin(5 * math.sqrt(3)), "peak P_ux": 0.1 / math.sqrt(3),
              "time of P_ux below 0": math.pi / math.sqrt(3)}  # in closed form


def restitution(history):
    """Returns the ratio of the momentum's peaks after and before its first change of sign."""
    momentum = history["linear_momentum_y"]
    first = int(np.argmax(momentum > 0))
    after = momentum[first:]
    end = int(np.argmax(after < 0)) if (after < 0).any() else len(after)
    return np.abs(after[:end]).max() / np.abs(momentum[:first]).max()


def peak_of(column):
    """Returns the function of a history that gives the largest magnitude of a column."""
    return lambda history: np.nanmax(np.abs(history[column]))


# By case: scene, settings, accuracies, fixed step of the finer run and its quantities, or exact values.
CASES = {
    "oscillator": ("tests/verification/oscillator.xml", [], ("0.1%",), None, OSCILLATOR),
    "short strip": ("strip", [f"{FINAL_TIME}=20", f"{RAMP}=10", "Mesh/Box/Divisions={160, 8}"], ("1%", "0.1%"), 0.005,
                    {"peak reaction_right_y": peak_of("reaction_right_y"),
                     "work": lambda history: history["external_work"][-1]}),
    "first waves in the strip": ("strip", [f"{FINAL_TIME}=3", f"{RAMP}=2"], ("1%", "0.1%"), 0.005,
                                 {"peak contact_force_y": peak_of("contact_force_y")}),
    "strip": ("strip", [f"{FINAL_TIME}=60"], ("1%",), 0.05,
              {"peak reaction_right_y [20, 60]": peak_of("reaction_right_y")}),
    "ball": ("ball", [f"{FINAL_TIME}=2"], ("3%", "1%"), 2e-5, {"restitution linear_momentum_y": restitution}),
}


def exact_values(context, scene, settings, step, quantities):
    """Returns the values of the quantities in closed form, or of a run with short steps."""
    if step is None:
        return quantities
    context.run(scene, [*settings, f"{TIME_STEP}={step}"], name="fine")
    history = context.history("fine")
    return {text: value(history) for text, value in quantities.items()}


def rows_of(summary, exact):
    """Yields a row for each quantity of a run to an accuracy."""
    found = summary["accuracy"]
    runs = found["runs"]
    for own in found["quantities"]:
        error = abs(own["value"] / exact[own["quantity"]] - 1)
        yield {"quantity": own["quantity"], "error": error, "reported error": own["error"],
               "steps of all runs, to the last's": sum(run["steps"] for run in runs) / runs[-1]["steps"],
               "seconds of all runs, to the last's": sum(run["seconds"] for run in runs) / runs[-1]["seconds"],
               "runs": len(runs), "steps of the last": summary["steps"], "kept": found["kept"]}


def measure(context):
    rows = []
    for case, (scene, settings, accuracies, step, quantities) in CASES.items():
        if context.trial and step is not None:
            continue
        exact = exact_values(context, scene, settings, step, quantities)
        named = [*settings, "Output/Quantities={" + ", ".join(quantities) + "}"]
        for accuracy in accuracies:
            summary = context.run(scene, named, options=["--accuracy", accuracy], allowed=(0, 3))  # 3: not kept
            rows += [dict(row, case=case, asked=accuracy if row["kept"] else f"{accuracy}, not kept")
                     for row in rows_of(summary, exact)]
    return rows


TABLES = [
    Table("accuracy", "docs/results/ball.md",
          [Column("case"), Column("asked"), Column("quantity"), Column("error", "{:.2g}"),
           Column("reported error", "{:.2g}"), Column("steps of all runs, to the last's", "{:.2f}"),
           Column("seconds of all runs, to the last's", "{:.2f}"), Column("runs"), Column("steps of the last", "{:,}")],
          measure, ("lib/study", "lib/time", "lib/solve", "lib/term", "xml/ball.xml", "xml/strip.xml"), minutes=2.5),
]
