"""Folders of studies without a run: errors and costs from formulas."""
import csv
import itertools
import json
import math

import scripts  # noqa: F401 (sets the path to the others)
from study_results import ERRORS, VALUES

SCHEMES = ["Newmark", "Generalized-Alpha", "Bathe Composite", "Average Vector Field", "Energy-Momentum",
           "Gautam-Sauer Composite"]
ELEMENTS = ["Q1C1", "Q1C4"]
STEPS = ["0.4", "0.2", "0.1", "0.05", "0.025"]
LARGEST = [0.06, 0.3, 0.15, 1, 1, 0.3]  # time step with which each scheme still works
REASON = "Newton's method did not converge"


def run_of(scheme, element, step, largest):
    """A row of study.csv by column: the finer the dearer and the more exact; Energy-Momentum has no error in energy."""
    number, size = SCHEMES.index(scheme), float(step)
    iterations = round(160 / size * (3 + 0.3 * number))
    failed = size > largest[number]
    force = 0.9 * size ** 1.8 * (1 + 0.6 * number % 3) * (0.4 if element == "Q1C4" else 1) + 2e-4
    energy = {3: 3e-12, 4: 0.0}.get(number, 0.3 * force)
    errors = dict(zip([*ERRORS, *VALUES], ("",) * 8 if failed else (
        energy, 2 * energy, force, "", 0.5 * force, "", 2 * (1 - 0.5 * force), 0.0)))  # the reference's peak is 2
    seconds = iterations * (0.004 + 0.0006 * number) * (0.3 if failed else 1)
    return {"run": f"{scheme}-{element}-{step}".replace(" ", "_"), "scheme": scheme, "element": element,
            "time step": step, "status": "diverged" if failed else "completed", "reason": REASON if failed else "",
            **errors, "wall_seconds": seconds, "cpu_seconds": 2 * seconds, "steps": round(160 / size),
            "rejected_steps": 0, "newton_iterations": iterations, "linear_iterations": 9 * iterations,
            "peak_memory_bytes": 212000000, "end_time": 31.25 if failed else 160}


def cheapest(rows, measure):
    """Names of the runs that no other beats in cost and in this measure."""
    known = sorted((row for row in rows if row[measure] != ""), key=lambda row: (row["wall_seconds"], row[measure]))
    return [row["run"] for place, row in enumerate(known) if row[measure] < min(
        (before[measure] for before in known[:place]), default=math.inf)]


def make(folder, schemes=SCHEMES, elements=ELEMENTS, steps=STEPS, largest=LARGEST):
    """Writes study.csv and study.json of a synthetic study."""
    axes = {"scheme": schemes, "element": elements, "time step": steps}
    rows = [run_of(*labels, largest) for labels in itertools.product(*axes.values())]
    within = [row for row in rows if row["error_force"] != "" and row["error_force"] < 0.01]
    best = min(within, key=lambda row: row["wall_seconds"], default=None)
    folder.mkdir()
    write_rows(folder, rows)
    write_data(folder, {
        "name": "Peeling of a strip", "scene": "xml/strip.xml", "command": "ixos-study strip-study.xml",
        "version": "1.2", "axes": [{"name": name, "values": labels} for name, labels in axes.items()],
        "connect": "time step", "cost": "wall_seconds", "measure": "error_force", "tolerance": 0.01,
        "reference": {"description": "Average Vector Field, time step 0.001", "folder": "strip.study/reference",
                      "judgement": "Its own errors are taken from a run with twice its time step.",
                      "own_errors": {"error_force": 0.0007}, "notes": ["work_error is blank: nothing is pulled."]},
        "pareto": {measure: cheapest(rows, measure) for measure in ERRORS},
        "recommendation": {
            "run": best and best["run"], "settings": best and [f"Time Integrator/Type={best['scheme']}"] or [],
            "sentence": "This is the cheapest run." if best else "No run reached the end."},
        "common": ["Output/Fields Interval=0"]})
    return folder


def write_rows(folder, rows):
    """Writes study.csv."""
    with open(folder / "study.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def write_data(folder, data):
    """Writes study.json."""
    (folder / "study.json").write_text(json.dumps(data))
