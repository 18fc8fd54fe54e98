#!/usr/bin/python3
"""Measures how often an advice is right, on random scenes, quantities and tolerances.

    tests/bench/advice_cases.py --seed $(git rev-parse HEAD) [--cases 100] [--minutes 50] [--grid 5] [--output FOLDER]

A case is a scene of xml/ with other gaps, laws, speeds, thicknesses, ramps and materials, or a small body in three
dimensions, with one quantity and one tolerance. The seed should be the hash of the commit that ended all tuning. For
each case the script asks ixos-study --advise, then runs the advised scene, and a reference with a quarter of its step
and half or a quarter of its cell length, by what that costs. Errors of the mesh fall with second order at best, so that
a difference from half the cell length counts 4/3 times. A case is kept if the difference is at most the tolerance.

For the first --grid advised cases the script runs a full grid as well: three schemes, three elements, four steps and
three meshes around the advised ones, but none that is finer in both. It tells the cheapest run within the tolerance,
and the cheapest of those whose finer runs in step and in mesh are within it, too: the others are so by coincidence.

Results are kept in OUTPUT/cases.json: the same command resumes.
"""
import argparse
import csv
import json
import pathlib
import random
import resource
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
STEP = "Time Integrator/Time Step Control/Time Step"
END = "Time Integrator/Time Step Control/Final Time"
START = 0.15  # seconds of processor time that a run takes to start


def draw(seed, number):
    """Returns a case: a scene, its changes, a quantity, a tolerance."""
    any_of = random.Random(f"{seed} {number}")
    kind = any_of.choice(["ball", "strip", "block"])
    wall = "Interactions/Wall/"
    settings = {wall + "Gamma W": "%.4g" % any_of.uniform(15, 60)}
    equilibrium = 0.255
    if kind != "strip":  # forces of a longer range, so that coarse meshes resolve them
        length = any_of.uniform(0.7, 2)
        settings[wall + "Gamma L"] = "%.4g" % (1 / length)
        equilibrium = 0.637 * length
    if any_of.random() < 0.3:
        settings = {wall + "Law": "Morse", wall + "Morse/Work of Adhesion": "%.4g" % any_of.uniform(0.02, 0.08),
                    wall + "Morse/Strength": "%.4g" % any_of.uniform(0.03, 0.1),
                    wall + "Morse/Equilibrium Gap": "%.4g" % equilibrium}
    if kind == "ball":
        settings["Mesh/Disk/Center"] = "{0, %.6g}" % (5 + equilibrium * any_of.uniform(1, 3))
        settings["Mesh/Disk/Core Divisions"], settings["Mesh/Disk/Rings"] = "8", "4"
        settings["Materials/Ball/Young's Modulus"] = "%.4g" % any_of.uniform(0.3, 2)
        settings["Initial Conditions/Velocity"] = "{0, %.4g}" % -any_of.uniform(2, 20)
        settings[END] = "%.4g" % any_of.uniform(0.05, 0.15)
        quantities = ["peak contact_force_y", "rms contact_force_y", "peak elastic_energy", "final kinetic_energy"]
    elif kind == "strip":
        thickness = any_of.choice([5, 10, 20])
        settings["Mesh/Box/Lengths"] = "{%d, %d}" % (100, thickness)
        settings["Mesh/Box/Divisions"] = "{80, %d}" % (thickness // 5 * 4)
        settings["Mesh/Sets/contact/Upper"] = "{%d, 1}" % any_of.choice([60, 75, 90])
        settings["Output/Probes/edge/Point"] = "{100, 0.254709287789268}"
        settings[wall + "Contact Element"] = any_of.choice(["Q1C1", "Q1C2", "Q1C4"])
        settings["Histories/Pull/Rate Ramp/Rate"] = "%.4g" % any_of.uniform(0.3, 1.5)
        settings["Histories/Pull/Rate Ramp/Length"] = "%.4g" % any_of.uniform(5, 20)
        settings[END] = "25"
        settings["Materials/Strip/Young's Modulus"] = "%.4g" % any_of.uniform(0.5, 2)
        quantities = ["peak reaction_right_y [5, 20]", "mean reaction_right_y [5, 20]", "rms reaction_right_y [5, 20]",
                      "work [0, 20]", "final elastic_energy", "value reaction_right_y at 15"]
    else:
        settings["Mesh/Box/Dimension"] = "3"
        settings["Mesh/Box/Lengths"] = "{4, 4, %d}" % any_of.choice([2, 4])
        settings["Mesh/Box/Divisions"] = settings["Mesh/Box/Lengths"]
        settings["Mesh/Box/Lower"] = "{0, 0, %.4g}" % (equilibrium * any_of.uniform(1, 3))
        settings["Initial Conditions/Velocity"] = "{0, 0, %.4g}" % -any_of.uniform(0, 30)
        settings[wall + "Side Set"] = "back"
        settings[END] = "%.4g" % any_of.uniform(0.03, 0.1)
        settings["Materials/Strip/Model"] = any_of.choice(["Neo-Hooke", "Linear Elastic", "Saint Venant-Kirchhoff"])
        quantities = ["peak contact_force_z", "rms contact_force_z", "energy error", "peak elastic_energy",
                      "final kinetic_energy"]
    return {"number": number, "kind": kind, "settings": settings, "quantity": any_of.choice(quantities),
            "tolerance": any_of.choice([0.05, 0.02, 0.01])}


BLOCK = """<ParameterList name="Block">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Strip"/></ParameterList>
  <ParameterList name="Interactions"><ParameterList name="Wall">
    <Parameter name="Side Set" type="string" value="back"/>
    <Parameter name="Gamma L" type="double" value="2.5"/>
    <Parameter name="Gamma W" type="double" value="25"/></ParameterList></ParameterList>
  <ParameterList name="Time Integrator"><Parameter name="Type" type="string" value="Average Vector Field"/>
    <ParameterList name="Time Step Control"><Parameter name="Final Time" type="double" value="0.1"/>
      <Parameter name="Time Step" type="double" value="0.0005"/></ParameterList></ParameterList>
</ParameterList>
"""


def scene_of(case, folder):
    """Returns the path of the case's scene."""
    if case["kind"] != "block":
        return ROOT / "xml" / (case["kind"] + ".xml")
    path = folder / "block.xml"
    path.write_text(BLOCK, encoding="utf-8")
    return path


def sets(settings):
    return [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]


def ask(case, scene, folder, driver, tolerance, budget):
    """Returns advice.json of the case, or None if there is none."""
    command = [driver, "--advise", scene, "--quantity", case["quantity"], "--tolerance", str(tolerance), "--output",
               folder, "--overwrite", "--budget", str(budget)]
    done = subprocess.run(command + sets(case["settings"]), capture_output=True, text=True, check=False)
    (folder.parent / (folder.name + ".log")).write_text(done.stdout + done.stderr, encoding="utf-8")
    path = folder / "advice.json"
    return json.loads(path.read_text(encoding="utf-8")) if done.returncode in (0, 3) and path.exists() else None


def scaled(settings, step, cells):
    """Returns the settings with a multiple of the step and of the cells along each edge; None if that is not whole."""
    result = dict(settings)
    for name, value in settings.items():
        last = name.rsplit("/", 1)[-1]
        if last == "Time Step":
            result[name] = repr(float(value) * step)
        elif last in ("Divisions", "Core Divisions", "Rings"):
            numbers = [int(n) * cells for n in value.strip("{}").split(",")]
            if any(n != int(n) or n < 1 for n in numbers) or (last == "Core Divisions" and numbers[0] % 2):
                return None
            text = ", ".join(str(int(n)) for n in numbers)
            result[name] = "{%s}" % text if "{" in value else text
    return result


def complete(case, recommended):
    """Returns all settings of the advised scene, with its step and mesh."""
    own = {**case["settings"], **recommended}
    own.setdefault(STEP, {"ball": "0.001", "strip": "0.1", "block": "0.0005"}[case["kind"]])
    return own


def measure(case, folder, study, driver, options):
    """Returns the case with its outcome."""
    folder.mkdir(parents=True, exist_ok=True)
    scene = scene_of(case, folder)
    advice = ask(case, scene, folder / "advice", study, case["tolerance"], options.budget)
    if advice is None:
        return dict(case, status="refused")
    result = dict(case, status=advice["status"], spent=advice["spent_seconds"], problem=advice["problem"],
                  runs=len(advice["runs"]))
    if advice["status"] != "advised":
        return result
    recommended = dict(setting.split("=", 1) for setting in advice["recommended"]["settings"])
    result["recommended"], result["seconds"] = recommended, advice["recommended"]["seconds"]
    result["promised"] = advice["recommended"]["error"]
    own = complete(case, recommended)
    # With the advised element and scheme, which have the same exact solution, but the scene's own model and tolerances.
    plain = complete(case, {name: value for name, value in recommended.items() if value != "Static" and
                            not name.endswith(("/Model", "Damping", "/Cutoff", "/Surface Points", "Solver/Tolerance"))})
    dimensions = 3 if case["kind"] == "block" else 2
    cells = 4 if 4 * 4**dimensions * max(0.05, result["seconds"] - START) <= options.reference else 2
    values = {}
    for name, settings in (("advised", own), ("reference", scaled(plain, 0.25, cells))):
        value = value_of(case, scene, settings, folder / name, driver, 6 * options.reference)
        if value is None:
            return dict(result, status="no reference")
        values[name] = value[0]
    result["values"], result["reference_cells"] = values, cells
    result["error"] = error_of(case, values["advised"], values["reference"]) * (4 / 3 if cells == 2 else 1)
    result["kept"] = result["error"] <= case["tolerance"]
    good = [run["seconds"] for run in advice["runs"]
            if run["good"] and error_of(case, run["values"][0], values["reference"]) <= case["tolerance"]]
    result["cheapest_of_runs"] = min(good + [result["seconds"]])
    return result


def error_of(case, value, exact):
    """Returns the relative error of a value; of an error, the value itself."""
    return value if case["quantity"] == "energy error" else abs(value - exact) / abs(exact)


def grid(case, folder, driver):
    """Returns the costs of the cheapest setting of a full grid within the tolerance: of all, and without coincidences."""
    own = complete(case, case["recommended"])
    scene, exact = scene_of(case, folder), case["values"]["reference"]
    wall, body = "Interactions/Wall/Contact Element", "Materials/%s/Element Formulation" % (
        "Ball" if case["kind"] == "ball" else "Strip")
    schemes = [{}, {"Time Integrator/Type": "Generalized-Alpha"}, {"Time Integrator/Type": "Bathe Composite"}]
    elements = [{}, {body: "Enhanced"}, {wall: "Q1C4"}]
    plain = complete(case, {name: own[name] for name in own if name == STEP or name.startswith("Mesh/") and
                            "Cell Order" not in name})
    all_costs, robust = [], []
    for scheme in schemes:
        for element in elements:
            errors = {}
            for i, step in enumerate((4, 2, 1, 0.5)):
                for j, cells in enumerate((0.25, 0.5, 1, 2)):
                    settings = scaled({**plain, **scheme, **element}, step, cells)
                    if settings is None or step < 1 and cells > 1:
                        continue
                    found = value_of(case, scene, settings, folder / "grid", driver, 60)
                    if found is not None:
                        errors[i, j] = (error_of(case, found[0], exact), found[1])
            for (i, j), (error, seconds) in errors.items():
                if error > case["tolerance"]:
                    continue
                all_costs.append(seconds)
                finer = [errors[k] for k in errors if k in ((i + 1, j), (i, j + 1))]
                if all(other <= case["tolerance"] for other, _ in finer):
                    robust.append(seconds)
    return {"grid": min(all_costs, default=None), "robust_grid": min(robust, default=None)}


def value_of(case, scene, settings, folder, driver, limit):
    """Returns the quantity of a run and its processor time; None if it fails or takes longer than a limit."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run([driver, scene, "--quiet", "--output", folder, "--overwrite"] + sets(settings) +
                              ["--set", "Output/Fields Interval=0", "--set", "Output/Fields Time Interval=0",
                               "--set", "Output/Checkpoint/Keep=0"], capture_output=True, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 1)))
    except subprocess.SubprocessError:
        return None
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        return None
    rows = list(csv.DictReader(open(folder / "history.csv", encoding="utf-8")))
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return evaluate(case["quantity"], rows, summary), seconds


def evaluate(quantity, rows, summary):
    """Evaluates a quantity on rows, independently of Ixos."""
    words = quantity.replace("[", " ").replace("]", " ").replace(",", " ").split()
    times = [float(row["time"]) for row in rows]
    if quantity == "energy error":
        return summary["max_energy_error"] / max(float(row["kinetic_energy"]) for row in rows)
    window = [float(w) for w in words[-2:]] if "[" in quantity else [times[0], times[-1]]
    column = "external_work" if words[0] == "work" else next(w for w in words[1:] if w in rows[0])
    chosen = [(t, float(row[column])) for t, row in zip(times, rows) if window[0] - 1e-9 <= t <= window[1] + 1e-9]
    if words[0] == "peak":
        return max(abs(v) for _, v in chosen)
    if words[:3] == ["time", "of", "peak"]:
        return max(chosen, key=lambda pair: abs(pair[1]))[0]
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


def report(cases):
    """Prints the numbers that count."""
    advised = [case for case in cases if "kept" in case]
    print(f"cases: {len(cases)}")
    for status in sorted({case["status"] for case in cases}):
        print(f"{status}: {sum(case['status'] == status for case in cases)}")
    if not advised:
        return
    print(f"within the tolerance: {sum(case['kept'] for case in advised)} of {len(advised)}")
    tell("error over the tolerance", [case["error"] / case["tolerance"] for case in advised])
    tell("processor time of the recommended run", [case["seconds"] for case in advised])
    tell("cost of the advice over that of the recommended run", [case["spent"] / case["seconds"] for case in advised])
    tell("runs of the advice", [case["runs"] for case in advised])
    tell("the same without what runs take to start", [(case["spent"] - START * case["runs"]) /
                                                      max(0.02, case["seconds"] - START) for case in advised])
    tell("cost over that of the cheapest run of the advice within the tolerance",
         [case["seconds"] / case["cheapest_of_runs"] for case in advised])
    for name, words in (("grid", "the cheapest of a grid"), ("robust_grid", "the cheapest of a grid, no coincidences")):
        tell(f"cost over that of {words}", [case["seconds"] / case[name] for case in advised if case.get(name)])


def tell(what, values):
    if values:
        print(f"{what}: median {statistics.median(values):.2f}, least {min(values):.2f}, most {max(values):.2f}"
              f" ({len(values)} cases)")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", required=True)
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--minutes", type=float, default=1e9, help="begin no case after so many minutes")
    parser.add_argument("--grid", type=int, default=5, help="advised cases whose full grid is run")
    parser.add_argument("--budget", type=float, default=20, help="seconds of processor time of an advice")
    parser.add_argument("--reference", type=float, default=15, help="seconds that a reference should take at most")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("advice-cases.results"))
    parser.add_argument("--drivers", type=pathlib.Path, default=ROOT / "build/release/drivers")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    record = options.output / "cases.json"
    done = json.loads(record.read_text(encoding="utf-8")) if record.exists() else {"seed": options.seed, "cases": []}
    if done["seed"] != options.seed:
        sys.exit(f"{record} has the cases of another seed; choose another --output")
    end = time.monotonic() + 60 * options.minutes
    for number in range(options.cases):
        if time.monotonic() > end:
            break
        if any(case["number"] == number for case in done["cases"]):
            continue
        folder = (options.output / f"case-{number}").resolve()
        case = measure(draw(options.seed, number), folder, options.drivers / "ixos-study", options.drivers / "ixos",
                       options)
        if "kept" in case and sum("grid" in other for other in done["cases"]) < options.grid:
            case.update(grid(case, folder, options.drivers / "ixos"))
        done["cases"].append(case)
        record.write_text(json.dumps(done, indent=1), encoding="utf-8")
        shown = ("number", "kind", "quantity", "tolerance", "status", "error", "promised", "seconds", "spent", "runs",
                 "grid", "robust_grid")
        print(json.dumps({key: case[key] for key in shown if key in case}), flush=True)
    report(done["cases"])


if __name__ == "__main__":
    main()
