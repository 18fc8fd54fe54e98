#!/usr/bin/python3
"""Measures how often an advice is right, on random scenes, quantities and tolerances.

    tests/bench/advice_cases.py --seed $(git rev-parse HEAD) [--cases 100] [--minutes 50] [--grid 8] [--output FOLDER]

advice_scenes.py draws the cases. The seed should be the hash of the commit that ended all tuning. For each case the
script asks ixos-study --advise with a budget, runs the advised scene, advised.xml, and compares it with a reference
that has quadratic cells, a finer mesh and a shorter step. A coarser reference tells how exact the reference is. A case
is kept if the difference is at most the tolerance. Of an energy error, the value is the error itself.

For every --grid-th case whose advice has settings, the script also runs a full grid as far as it is cheaper than the
advised settings: three schemes, four elements, and a fourth to eight times the scene's step and a fourth to twice its
cells along an edge. It tells the cheapest run within the tolerance, and the cheapest of those that are not so by
coincidence: a run with half the step, and one with twice the cells along an edge, are within the tolerance, too.

Each case is a line of OUTPUT/cases.jsonl: the same command resumes. --report FILE prints the numbers of such a file.
docs/figures/tables/advice.py makes a table of a few cases.
"""
import argparse
import csv
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import time

import advice_scenes
from advice_scenes import BODY, ELEMENT, ROOT, SCHEME, STEP, scaled

STEP_MEANS = ("Average Vector Field", "Energy-Momentum", "Gautam-Sauer Composite")  # reactions of the step's middle


class Runs:
    """Runs of a case's scene."""

    def __init__(self, case, folder, drivers):
        self.case, self.folder, self.drivers = case, folder, drivers
        self.scene = advice_scenes.scene_of(case, folder)
        self.run_scheme = case["settings"][SCHEME]

    def value(self, name, settings, limit, scene=None):
        """Returns the quantity of a run, None if it fails or takes longer than a limit, and its processor time."""
        words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(
            [self.drivers / "ixos", scene or self.scene, "--quiet", "--output", self.folder / name, "--overwrite"] +
            words + ["--set", "Output/Fields Interval=0", "--set", "Output/Fields Time Interval=0", "--set",
                     "Output/Checkpoint/Keep=0"],
            capture_output=True, check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2)))
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if done.returncode != 0:
            return None, seconds
        rows = list(csv.DictReader(open(self.folder / name / "history.csv", encoding="utf-8")))
        summary = json.loads((self.folder / name / "summary.json").read_text(encoding="utf-8"))
        scheme = settings.get(SCHEME, self.run_scheme)
        return evaluate(self.case["quantity"], rows, summary, scheme in STEP_MEANS), seconds

    def advice(self, budget):
        """Returns advice.json of the case, or None if there is none."""
        words = [word for key, value in self.case["settings"].items() for word in ("--set", f"{key}={value}")]
        done = subprocess.run(
            [self.drivers / "ixos-study", "--advise", self.scene, "--quantity", self.case["quantity"], "--tolerance",
             str(self.case["tolerance"]), "--output", self.folder / "advice", "--budget", str(budget)] + words,
            capture_output=True, text=True, check=False)
        (self.folder / "advice.log").write_text(done.stdout + done.stderr, encoding="utf-8")
        path = self.folder / "advice/advice.json"
        return json.loads(path.read_text(encoding="utf-8")) if done.returncode in (0, 3, 4) and path.exists() else None

    def error(self, value, exact):
        """Returns the relative error of a value; of an error, the value itself."""
        return value if self.case["quantity"] == "energy error" else abs(value - exact) / abs(exact)


def evaluate(quantity, rows, summary, step_means):
    """Evaluates a quantity on rows, independently of Ixos."""
    words = quantity.replace("[", " ").replace("]", " ").replace(",", " ").split()
    if quantity == "energy error":
        return summary["max_energy_error"] / max(float(row["kinetic_energy"]) for row in rows)
    column = "external_work" if words[0] == "work" else next(w for w in words[1:] if w in rows[0])
    half = 0.5 if step_means and column.startswith("reaction_") else 0
    pairs = [(float(row["time"]) - half * float(row["time_step"]), float(row[column])) for row in rows]
    window = [float(w) for w in words[-2:]] if "[" in quantity else [pairs[0][0], pairs[-1][0]]
    chosen = [(t, v) for t, v in pairs if window[0] - 1e-9 <= t <= window[1] + 1e-9]
    if words[0] == "peak":
        return max(abs(v) for _, v in chosen)
    if words[0] == "work":
        return chosen[-1][1] - chosen[0][1]
    if words[0] == "final":
        return chosen[-1][1]
    if words[0] == "value":
        at = float(words[-1])
        for (t0, v0), (t1, v1) in zip(chosen, chosen[1:]):
            if t0 <= at <= t1:
                return v0 + (v1 - v0) * (at - t0) / (t1 - t0)
        raise ValueError(quantity)
    power = 2 if words[0] == "rms" else 1
    total = sum((t1 - t0) * (v0**power + v1**power) / 2 for (t0, v0), (t1, v1) in zip(chosen, chosen[1:]))
    mean = total / (chosen[-1][0] - chosen[0][0])
    return mean**0.5 if power == 2 else mean


def measure(case, runs, options):
    """Returns the case with its outcome."""
    advice = runs.advice(options.budget)
    if advice is None:
        return dict(case, status="refused")
    result = dict(case, status=advice["status"], spent=advice["spent_seconds"], problem=advice["problem"],
                  runs=len(advice["runs"]))
    if advice["status"] != "advised" and not options.reference_always:
        return result
    is_error = case["quantity"] == "energy error"  # which needs no reference
    fine, coarse = ((None, 0) if is_error else runs.value(f"reference-{i}", settings, options.reference)
                    for i, settings in enumerate(advice_scenes.references(case)))
    if advice["status"] != "advised":
        return dict(result, reference=fine[0], coarser=coarse[0])
    recommended = dict(setting.split("=", 1) for setting in advice["recommended"]["settings"])
    result["recommended"] = advice["recommended"]["description"]
    result["promised"] = advice["recommended"]["error"]
    runs.run_scheme = recommended.get(SCHEME, runs.run_scheme)
    advised = runs.value("advised", {}, 60, runs.folder / "advice/advised.xml")
    runs.run_scheme = case["settings"][SCHEME]
    if advised[0] is None:
        return dict(result, status="advised run failed", kept=False)
    result["value"], result["seconds"] = advised
    if is_error:
        result["error"] = advised[0]
    elif fine[0] is None or coarse[0] is None:
        return dict(result, status="no reference")
    else:
        result["reference"], result["coarser"] = fine[0], coarse[0]
        result["reference_change"] = runs.error(coarse[0], fine[0])
        result["error"] = runs.error(advised[0], fine[0])
    result["kept"] = result["error"] <= case["tolerance"]
    return result


def grid(result, runs):
    """Returns the costs of the cheapest setting of a full grid within the tolerance: of all, and without coincidences.

    Runs that take longer than the advised one, which is within the tolerance, are left out, for they do not count. A
    run is no coincidence if half its step and half its cells' length are within the tolerance, too."""
    kind, tolerance, most = result["kind"], result["tolerance"], result["seconds"]
    own = result["settings"]
    elements = [{}, {BODY[kind] + "Element Formulation": "Enhanced"}, {ELEMENT: "Q1C4"},
                {"Mesh/Cell Order": "2", ELEMENT: "Q2C2"}]
    steps, meshes = (8, 4, 2, 1, 0.5, 0.25), (0.25, 0.5, 1, 2)
    costs, robust = [most], [most]
    for scheme in dict.fromkeys([own[SCHEME], "Generalized-Alpha", "Bathe Composite"]):
        for element in elements:
            found, dear = {}, []

            def run(i, j, limit):
                if (i, j) not in found:
                    settings = scaled({**own, SCHEME: scheme, **element}, steps[i], meshes[j])
                    found[i, j] = (None, 0) if settings is None else runs.value("grid", settings, limit)
                return found[i, j]

            def within(i, j, limit):
                if not (0 <= i < len(steps) and 0 <= j < len(meshes)):
                    return False
                value = run(i, j, limit)[0]
                return value is not None and runs.error(value, result.get("reference")) <= tolerance

            for j in range(len(meshes)):
                for i in range(len(steps)):
                    if any(k <= i and l <= j for k, l in dear):
                        break
                    seconds = run(i, j, most)[1]
                    if seconds > most:
                        dear.append((i, j))
                    elif within(i, j, most):
                        costs.append(seconds)
                        if seconds < min(robust) and within(i + 1, j, 60) and within(i, j + 1, 60):
                            robust.append(seconds)
    return {"grid": min(costs), "robust_grid": min(robust)}


def report(cases):
    """Prints the numbers that count, of all cases and by kind."""
    for kind in ("all", *sorted({case["kind"] for case in cases})):
        some = [case for case in cases if kind in ("all", case["kind"])]
        judged = [case for case in some if case.get("kept") is not None]
        print(f"{kind}: {len(some)} cases;",
              ", ".join(f"{status} {sum(case['status'] == status for case in some)}"
                        for status in sorted({case["status"] for case in some})))
        if not judged:
            continue
        print(f"  within the tolerance: {sum(case['kept'] for case in judged)} of {len(judged)}")
        tell("error over the tolerance", [case["error"] / case["tolerance"] for case in judged])
        tell("change of the reference over the tolerance",
             [case["reference_change"] / case["tolerance"] for case in judged if case.get("reference_change")])
        tell("processor time of the advised run", [case["seconds"] for case in judged])
        tell("of the advice", [case["spent"] for case in judged])
        tell("of the advice over that of the advised run", [case["spent"] / case["seconds"] for case in judged])
        for name, words in (("grid", "a grid"), ("robust_grid", "a grid, no coincidences")):
            tell(f"of the advised run over that of the cheapest of {words}",
                 [case["seconds"] / case[name] for case in judged if case.get(name)])


def tell(what, values):
    if values:
        print(f"  {what}: median {statistics.median(values):.2f}, least {min(values):.2g}, most {max(values):.3g}"
              f" ({len(values)} cases)")


def lines(path):
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--minutes", type=float, default=1e9, help="begin no case after so many minutes")
    parser.add_argument("--grid", type=int, default=8, help="a grid for one of so many advised cases; 0: none")
    parser.add_argument("--budget", type=float, default=20, help="seconds of processor time of an advice")
    parser.add_argument("--reference", type=float, default=60, help="seconds that a reference may take")
    parser.add_argument("--reference-always", action="store_true", help="run references also without an advice")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("advice-cases.results"))
    parser.add_argument("--drivers", type=pathlib.Path, default=ROOT / "build/release/drivers")
    parser.add_argument("--report", type=pathlib.Path)
    options = parser.parse_args()
    if options.report:
        report(lines(options.report))
        return
    if not options.seed:
        parser.error("--seed is missing")
    options.output.mkdir(parents=True, exist_ok=True)
    record = options.output / "cases.jsonl"
    done = lines(record)
    settings = {name: getattr(options, name) for name in ("seed", "budget", "reference", "reference_always", "grid")}
    for name, value in settings.items():
        if any(case["options"][name] != value for case in done):
            sys.exit(f"{record} has cases with another --{name.replace('_', '-')}; choose another --output")
    end = time.monotonic() + 60 * options.minutes
    for number in range(options.first, options.first + options.cases):
        if time.monotonic() > end:
            break
        if any(case["number"] == number for case in done):
            continue
        folder = (options.output / f"case-{number}").resolve()
        folder.mkdir(exist_ok=True)
        case = advice_scenes.draw(options.seed, number)
        runs = Runs(case, folder, options.drivers.resolve())
        begin = time.monotonic()
        case = dict(measure(case, runs, options), options=settings)
        advised = sum("kept" in other for other in done)
        if case.get("kept") and options.grid and advised % options.grid == 0:
            case.update(grid(case, runs))
        case["wall_seconds"] = round(time.monotonic() - begin, 1)
        done.append(case)
        with open(record, "a", encoding="utf-8") as file:
            file.write(json.dumps(case) + "\n")
        shown = ("number", "kind", "quantity", "tolerance", "status", "error", "promised", "reference_change",
                 "seconds", "spent", "runs", "grid", "robust_grid", "wall_seconds")
        print(json.dumps({key: case[key] for key in shown if key in case}), flush=True)
    report(done)


if __name__ == "__main__":
    main()
