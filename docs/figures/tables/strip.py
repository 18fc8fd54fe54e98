"""The strip's tables of docs/results/strip.md."""
from .. import increments
from ..bodies import MECHANICS
from ..runs import FINAL_TIME, forms, markdown_rows, measures, results
from ..table import Column, Table

PAGE = "docs/results/strip.md"
ELEMENT, DIVISIONS = "Interactions/Wall/Contact Element", "Mesh/Box/Divisions"
SCHEMES = ("Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field", "Energy-Momentum")
SHORT = [f"{DIVISIONS}={{80, 4}}", f"{forms.RAMP}2"]  # of a trial

# Central Difference alone would take most of the study's time: one run shows it.
STUDY = forms.ShortStudy({}, {"Scheme": ["Newmark", "Bathe", "Composite", "Average Vector Field", "Energy-Momentum",
                                         "Generalized-Alpha"],
                              "Contact Element": ["Q1C1", "Q1C4"], "Time Step": ["1", "0.5", "0.1"]}, {})
EXPLICIT = STUDY._replace(axes={"Scheme": ["Central Difference"], "Contact Element": ["Q1C1"], "Time Step": ["1"]})


def measure_accuracy(context):
    study = context.study("strip-study", STUDY)
    runs = list(study.runs.values())
    if not context.trial:  # which has all schemes
        runs += context.study("strip-study", EXPLICIT).runs.values()  # its reference is the same, and kept
    base = next(run["cpu_seconds"] for run in runs if run["Scheme"] == "Newmark")
    rows = {}
    for run in runs:
        row = rows.setdefault((run["Scheme"], run["Contact Element"]),
                              {"scheme": run["Scheme"], "contact element": run["Contact Element"]})
        row[f"error, Δt = {run['Time Step']}"] = study.error(run, "error_force")
        row[f"time, Δt = {run['Time Step']}"] = run["cpu_seconds"] / base
    return list(rows.values())


STUDY_STEPS = STUDY.axes["Time Step"]
ACCURACY_COLUMNS = [Column("scheme"), Column("contact element"),
                    *(Column(f"error, Δt = {step}", "{:.4f}") for step in STUDY_STEPS),
                    *(Column(f"time, Δt = {step}", "{:.1f}") for step in STUDY_STEPS)]


def measure_elements(context):
    """The force oscillates as the front passes from side to side. Times are those of an iteration."""
    rows, base = [], None
    interval, window = context.pick(((45, 115), 4), ((1, 3), 1))
    for element in ("Q1C1", "Q1C2", "Q1C3", "Q1C4", "Q1CH"):
        done = context.run("strip", [f"{ELEMENT}={element}", *context.pick([], [*SHORT, f"{FINAL_TIME}=4"])])
        run = results.Run(context.folder / "run")
        _, times, force = run.reaction()
        early = times <= 100  # later the strip snaps off
        seconds = done["wall_seconds"] / done["newton_iterations"]
        base = base or seconds
        rows.append({"contact element": element, "oscillation": measures.oscillation(times, force, interval, window)[1],
                     "an iteration, to Q1C1's": seconds / base, "peak force": force[early].max(),
                     "iterations an increment": done["newton_iterations"] / done["steps"],
                     "degrees of freedom": done["dofs"]})
    return rows


def measure_points(context):
    """The program finds the static equilibrium at a time, with each contact element."""
    rows = markdown_rows(context.run_text("contact_quadrature", "xml/strip.xml", context.pick(60, 1)))
    return [{head: cell if head == "element" else float(cell) for head, cell in row.items() if head} for row in rows]


POINTS = (2, 3, 4, 5, 6, 8, 10, 12, 16)


def measure_increment(context):
    """No frames, and no enrichment: the schemes' own cost."""
    samples = increments.measure(context, "strip", (60, 2), (*SCHEMES, increments.BY_KLU), 3,
                                 [f"{ELEMENT}=Q1C1", *context.pick([], SHORT)])
    return increments.increment_rows(samples)


CODE = (*MECHANICS, "lib/run", "xml/strip.xml")
TABLES = [
    Table("strip-accuracy", PAGE, ACCURACY_COLUMNS, measure_accuracy, (*CODE, "lib/study", "xml/strip-study.xml"),
          minutes=3),
    Table("strip-elements", PAGE,
          [Column("contact element"), Column("oscillation", "{:.1e}"), Column("an iteration, to Q1C1's", "{:.2f}"),
           Column("peak force", "{:.5f}"), Column("iterations an increment", "{:.2f}"),
           Column("degrees of freedom", "{:,}")], measure_elements, CODE, minutes=1.2),
    Table("surface-points", PAGE, [Column("element"), *(Column(str(count), "{:.1e}") for count in POINTS)],
          measure_points, ("lib/interaction", "lib/term", "lib/fem", "xml/strip.xml"), ("contact_quadrature",),
          minutes=0.5),
    Table("strip-increment", PAGE, increments.INCREMENT_COLUMNS, measure_increment, CODE, minutes=1.5),
]
