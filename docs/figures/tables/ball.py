"""The ball's tables: README.md's, and those of docs/results/ball.md."""
import xml.etree.ElementTree as ElementTree

import numpy as np

from .. import increments
from ..bodies import MECHANICS
from ..runs import FINAL_TIME, SCHEME, forms, interleaved
from ..table import ROOT, Column, Table

PAGE = "docs/results/ball.md"
AVF = "Average Vector Field"
END = (10, 0.5)  # of a measurement, of a trial
SCHEMES = ("Newmark", "Bathe Composite", "Gautam-Sauer Composite", AVF, "Energy-Momentum", "Generalized-Alpha",
           "HHT-Alpha", "Midpoint", "Central Difference")
POINTS = {f"{AVF}, exact mean of the interaction": {"Interaction Points": 0},
          f"{AVF}, 5 points of the interaction": {"Interaction Points": 5},
          f"{AVF}, 3 elastic points, 5 of the interaction": {"Elastic Points": 3, "Interaction Points": 5}}


def settings_of(variant):
    """Returns the settings of a scheme, or of Average Vector Field with other points."""
    points = POINTS.get(variant, {})
    return [f"{SCHEME}={AVF if points else variant}",
            *(f"Time Integrator/{AVF}/{name}={value}" for name, value in points.items())]


def measure_runs(context, variants):
    """Runs the ball to its end with each variant in turns. Times are relative to those of Average Vector Field."""
    found = {}

    def figures(variant):
        settings = [*settings_of(variant), f"{FINAL_TIME}={context.pick(*END)}"]
        done = found[variant] = context.run("ball", settings, frames=True, allowed=(0, 3))  # 3: it diverged
        return {"seconds": done["wall_seconds"] if done["status"] == "completed" else None}

    samples = interleaved([AVF, *(name for name in variants if name != AVF)], context.pick(3, 1), figures)
    for variant in variants:
        done, sample = found[variant], samples[variant]
        end = f"{done['end_time']:.3g} ns"
        yield {"scheme": variant, "reaches": end if done["status"] == "completed" else f"fails at {end}",
               "largest energy error, over the energy scale": done["max_energy_error"] / done["largest_energy"],
               "iterations a step": done["newton_iterations"] / done["steps"] or None,
               "time, to Average Vector Field's": sample.ratio.get("seconds"),
               "seconds on one core": sample.median.get("seconds")}


RUN_COLUMNS = [Column("scheme"), Column("reaches"), Column("largest energy error, over the energy scale", "{:.1g}"),
               Column("time, to Average Vector Field's", "{:.2f}"), Column("iterations a step", "{:.2f}"),
               Column("seconds on one core", "{:.1f}")]


def measure_readme(context):
    return list(measure_runs(context, [*SCHEMES[:5], SCHEMES[-1]]))


def measure_schemes(context):
    return list(measure_runs(context, [*SCHEMES, *POINTS]))


# The paper's times of an increment relative to Newmark's: Gautam and Sauer (2014), section 4.1.
PAPER = {"Bathe Composite": 1.95, "Gautam-Sauer Composite": 1.15, "Energy-Momentum": 13.9}


def measure_increment(context):
    """All schemes complete the first 1.4 T0."""
    rows = increments.increment_rows(increments.measure(context, "ball", (1.4, 0.2), (*SCHEMES, increments.BY_KLU), 5))
    return [dict(row, **{"the paper's": PAPER.get(row["scheme"])}) for row in rows]


STEPS = ("0.0005", "0.0002", "0.00005")  # of the columns of errors
TIMED = STEPS[1]


def measure_errors(context):
    """Runs the study. Times are processor times of one run each."""
    study = context.study("ball-study")
    steps = dict(zip(STEPS, context.pick(STEPS, ("0.01", "0.002", "0.002"))))
    rows = {}
    for run in study.runs.values():
        row = rows.setdefault(run["Scheme"], {"scheme": run["Scheme"]})
        for name, step in steps.items():
            if float(run["Time Step"]) == float(step):
                row["position " + name], row["energy " + name] = (study.error(run, f"error_{what}")
                                                                  for what in ("position", "energy"))
                row["seconds " + name] = run["cpu_seconds"]
        if run is study.best:
            row["recommended"] = run["Time Step"]
    for row in rows.values():
        row["time"] = row["seconds " + TIMED] / rows["Newmark"]["seconds " + TIMED]
    return list(rows.values())


ERROR_COLUMNS = [Column("scheme"), Column(f"processor time at Δt = {TIMED}, to Newmark's", "{:.2f}", "time"),
                 *(Column(f"position, Δt = {step}", "{:.2g}", f"position {step}") for step in STEPS),
                 *(Column(f"energy, Δt = {step}", "{:.1g}", f"energy {step}") for step in STEPS[1:]),
                 Column("recommended Δt", key="recommended")]
# Scheme, control and level of the rows.
CONTROLLED = [("Newmark", "Gap ratio", "3"), ("Newmark", "Gap ratio", "4"), ("Newmark", "Gap ratio", "5"),
              ("Newmark", "Gap ratio", "7"), ("Newmark", "Local error", "4"), ("Newmark", "Local error", "5"),
              ("Composite", "Gap ratio", "4"), ("Composite", "Gap ratio", "5"), ("Composite", "Local error", "5")]
BOUNDS = {"Gap ratio": "Maximum Gap Ratio", "Local error": "Tolerance"}


def bound(control, level):
    """Returns what a level of the study allows to a control."""
    entry = ElementTree.parse(ROOT / "xml/ball-adaptive-study.xml").getroot()
    for name in ("Axes", "Level", "Settings", level):
        entry = forms.named(entry, "ParameterList", name)
    path = f"Time Integrator/Time Step Control/Adaptive/{BOUNDS[control]}"
    return forms.named(entry, "Parameter", path).get("value")


def fixed_iterations(runs, scheme, error):
    """Returns the Newton iterations of fixed steps for an error of the energy, interpolated; NaN beyond the runs."""
    points = sorted((np.log(run["error_energy"]), np.log(run["newton_iterations"])) for run in runs
                    if (run["Scheme"], run["Control"]) == (scheme, "Fixed") and run["error_energy"] > 0)
    return float(np.exp(np.interp(np.log(error), *zip(*points), left=np.nan, right=np.nan)))


def measure_adaptive(context):
    runs = list(context.study("ball-adaptive-study").runs.values())
    rows = []
    for run in runs:
        key = (run["Scheme"], run["Control"], run["Level"])
        if key in CONTROLLED or context.trial and run["Control"] in BOUNDS:
            fixed = fixed_iterations(runs, run["Scheme"], run["error_energy"])
            rows.append({"scheme": run["Scheme"], "control": f"{run['Control'].lower()} {bound(*key[1:])}",
                         "iterations of fixed steps, to these": fixed / run["newton_iterations"],
                         "error of the energy": run["error_energy"], "Newton iterations": run["newton_iterations"]})
    order = {key: place for place, key in enumerate(dict.fromkeys((row["scheme"], row["control"]) for row in rows))}
    return sorted(rows, key=lambda row: order[row["scheme"], row["control"]])


CODE = (*MECHANICS, "lib/run", "xml/ball.xml")
TABLES = [
    Table("ball", "README.md", [column for column in RUN_COLUMNS if column.title != "iterations a step"],
          measure_readme, CODE, minutes=0.5),
    Table("ball-schemes", PAGE, RUN_COLUMNS, measure_schemes, CODE, minutes=1.5),
    Table("ball-increment", PAGE, [*increments.INCREMENT_COLUMNS[:2], Column("the paper's", "{:.2f}"),
                                   *increments.INCREMENT_COLUMNS[2:]], measure_increment, CODE, minutes=0.5),
    Table("ball-errors", PAGE, ERROR_COLUMNS, measure_errors, (*CODE, "xml/ball-study.xml"), minutes=1.5),
    Table("ball-adaptive", PAGE, [Column("scheme"), Column("control"),
                                  Column("iterations of fixed steps, to these", "{:.1f}"),
                                  Column("error of the energy", "{:.1e}"), Column("Newton iterations", "{:,.0f}")],
          measure_adaptive, (*CODE, "xml/ball-adaptive-study.xml"), minutes=2),
]
