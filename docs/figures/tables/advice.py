"""Tables of the advice of `ixos-study --advise`: for the strip with several tolerances, and for random scenes."""
import json
import pathlib
import statistics

from .. import machine
from ..bodies import MECHANICS
from ..runs import FINAL_TIME, TIME_STEP, measures, results
from ..table import Column, Table
from .strip import DIVISIONS, SHORT

PAGE = "docs/results/strip.md"
UNTIL = 100  # later the strip snaps off; xml/strip.xml names the largest reaction up to this time as its quantity


def largest_force(context, name):
    """Returns the largest force of a run before the snap-off."""
    _, times, force = results.Run(context.folder / name).reaction()
    return measures.peak(times[times <= UNTIL], force[times <= UNTIL])[1]


def advise(context, tolerance, fine):
    """Asks for an advice. Returns its row; `fine` is the quantity of a run with a fine mesh and short steps."""
    folder = context.folder / f"advice-{tolerance}"
    changes = context.pick([], [*SHORT, f"{FINAL_TIME}=4", f"{TIME_STEP}=0.2"])
    quantity = context.pick([], ["--quantity", "peak reaction_right_y"])
    context.execute([context.program("ixos-study"), "--advise", "xml/strip.xml", *quantity, "--tolerance", tolerance,
                     "--output", folder, *(word for change in changes for word in ("--set", change))], (0, 3, 4))
    advice = json.loads(pathlib.Path(folder, "advice.json").read_text(encoding="utf-8"))
    if advice["status"] != "advised":
        return {"tolerance": tolerance, "recommended": advice["status"]}
    context.run(str(folder / "advised.xml"), name="advised")
    best = advice["recommended"]
    return {"tolerance": tolerance, "recommended": best["description"], "error to expect": best["error"],
            "error": abs(largest_force(context, "advised") / fine - 1),
            "advice, to the run": advice["spent_seconds"] / best["seconds"], "seconds of the run": best["seconds"]}


def measure_strip(context):
    context.run("strip", context.pick([f"{DIVISIONS}={{640, 32}}", f"{FINAL_TIME}=62"], [*SHORT, f"{FINAL_TIME}=4"]),
                name="fine")
    fine = largest_force(context, "fine")
    return [advise(context, tolerance, fine) for tolerance in context.pick(("2%", "1%", "0.5%"), ("5%",))]


def measure_cases(context):
    """The seed is the present commit, so that nothing is tuned to the cases."""
    folder = context.folder / "cases"
    context.run_text("tests/bench/advice_cases.py", "--seed", machine.commit(), "--cases", context.pick(10, 2),
                     "--budget", context.pick(20, 3), "--grid", 0, "--drivers", context.build / "drivers", "--output",
                     folder)
    cases = [json.loads(line) for line in (folder / "cases.jsonl").read_text(encoding="utf-8").splitlines()]
    kinds = sorted({case["kind"] for case in cases})
    return [row_of(kind, [case for case in cases if case["kind"] == kind]) for kind in kinds] + [row_of("all", cases)]


def row_of(kind, cases):
    """Returns the row of some cases. An advised run that failed is judged, but has neither an error nor a time; one
    without a reference is not judged."""
    judged = [case for case in cases if case.get("kept") is not None]
    ran = [case for case in judged if "error" in case]
    row = {"scenes": kind, "cases": len(cases), "advised": sum("recommended" in case for case in cases),
           "judged": len(judged), "within the tolerance": sum(case["kept"] for case in judged)}
    if ran:
        ratios = [case["spent"] / case["seconds"] for case in ran]
        row.update({"error, to the tolerance": statistics.median(case["error"] / case["tolerance"] for case in ran),
                    "advice, to the run": statistics.median(ratios), "at most": max(ratios),
                    "seconds of the run": statistics.median(case["seconds"] for case in ran)})
    return row


CODE = (*MECHANICS, "lib/study", "lib/run")
TABLES = [
    Table("strip-advice", PAGE,
          [Column("tolerance"), Column("recommended"), Column("advice, to the run", "{:.1f}"),
           Column("error to expect", "{:.4f}"), Column("error", "{:.4f}"), Column("seconds of the run", "{:.2f}")],
          measure_strip, CODE, minutes=3),
    Table("advice-cases", PAGE,
          [Column("scenes"), Column("cases"), Column("advised"), Column("judged"), Column("within the tolerance"),
           Column("error, to the tolerance", "{:.2f}"), Column("advice, to the run", "{:.1f}"),
           Column("at most", "{:.0f}"), Column("seconds of the run", "{:.2f}")],
          measure_cases, (*CODE, "tests/bench/advice_scenes.py"), minutes=5),
]
