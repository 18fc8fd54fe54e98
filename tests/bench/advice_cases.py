#!/usr/bin/python3
"""Measures how often an advice is right, on random scenes, quantities and tolerances.

    tests/bench/advice_cases.py --seed $(git rev-parse HEAD) [--cases 100] [--first 0] [--output advice-cases.results]

A case is a scene of xml/ with other gaps, laws, speeds, thicknesses, ramps and materials, or a small body in three
dimensions, with one quantity and one tolerance. The seed should be the hash of the commit that ended all tuning. For
each case the script asks ixos-study --advise, then runs the advised scene, and the scene with a quarter of the advised
step and a quarter of the advised cell length. It counts a case as kept if the two differ by at most the tolerance. It
compares the cost of the advised scene with that of the cheapest run of the advice within the tolerance, which stands for
the cheapest setting of a full grid; such a run may be accurate by coincidence. Results are kept in OUTPUT/cases.json:
the same command resumes.
"""
import argparse
import csv
import json
import pathlib
import random
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STEP = "Time Integrator/Time Step Control/Time Step"
END = "Time Integrator/Time Step Control/Final Time"


def draw(seed, number):
    """Returns a case: a scene, its changes, a quantity, a tolerance."""
    any_of = random.Random(f"{seed} {number}")
    kind = any_of.choice(["ball", "strip", "block"])
    wall = "Interactions/Wall/"
    settings = {wall + "Gamma W": "%.4g" % any_of.uniform(15, 60)}
    if any_of.random() < 0.3:
        settings = {wall + "Law": "Morse", wall + "Morse/Work of Adhesion": "%.4g" % any_of.uniform(0.008, 0.03),
                    wall + "Morse/Strength": "%.4g" % any_of.uniform(0.03, 0.1)}
    if kind == "ball":
        settings["Mesh/Disk/Center"] = "{0, %.6g}" % (5 + any_of.uniform(0.3, 2))
        settings["Mesh/Disk/Core Divisions"], settings["Mesh/Disk/Rings"] = "16", "8"
        settings["Materials/Ball/Young's Modulus"] = "%.4g" % any_of.uniform(0.3, 2)
        settings["Initial Conditions/Velocity"] = "{0, %.4g}" % -any_of.uniform(2, 20)
        settings[END] = "%.4g" % any_of.uniform(0.15, 0.4)
        quantities = ["peak contact_force_y", "rms contact_force_y", "energy error", "final linear_momentum_y",
                      "final elastic_energy", "time of peak contact_force_y"]
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
        settings["Mesh/Box/Divisions"] = "{8, 8, %d}" % (2 * int(settings["Mesh/Box/Lengths"][7:8]))
        settings["Mesh/Box/Lower"] = "{0, 0, %.4g}" % any_of.uniform(0.4, 1)
        settings["Initial Conditions/Velocity"] = "{0, 0, %.4g}" % -any_of.uniform(0, 30)
        settings[wall + "Side Set"] = "back"
        settings[END] = "%.4g" % any_of.uniform(0.05, 0.15)
        settings["Materials/Strip/Model"] = any_of.choice(["Neo-Hooke", "Linear Elastic", "Saint Venant-Kirchhoff"])
        quantities = ["peak contact_force_z", "rms contact_force_z", "energy error", "final linear_momentum_z",
                      "final elastic_energy"]
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


def ask(case, scene, folder, driver, tolerance):
    """Returns advice.json of the case, or None if there is none."""
    command = [driver, "--advise", scene, "--quantity", case["quantity"], "--tolerance", str(tolerance), "--output",
               folder, "--overwrite"]
    done = subprocess.run(command + sets(case["settings"]), capture_output=True, text=True, check=False)
    (folder.parent / (folder.name + ".log")).write_text(done.stdout + done.stderr, encoding="utf-8")
    path = folder / "advice.json"
    return json.loads(path.read_text(encoding="utf-8")) if done.returncode in (0, 3) and path.exists() else None


def finer(settings):
    """Returns the settings with half the step and twice the cells along each edge."""
    result = dict(settings)
    for name, value in settings.items():
        last = name.rsplit("/", 1)[-1]
        if last == "Time Step":
            result[name] = repr(float(value) / 2)
        elif last in ("Divisions", "Core Divisions", "Rings"):
            numbers = [2 * int(n) for n in value.strip("{}").split(",")]
            result[name] = "{%s}" % ", ".join(map(str, numbers)) if "{" in value else str(numbers[0])
    return result


def measure(case, folder, study, driver):
    """Returns the case with its outcome."""
    folder.mkdir(parents=True, exist_ok=True)
    scene = scene_of(case, folder)
    advice = ask(case, scene, folder / "advice", study, case["tolerance"])
    if advice is None:
        return dict(case, status="refused")
    result = dict(case, status=advice["status"], spent=advice["spent_seconds"], problem=advice["problem"])
    if advice["status"] != "advised":
        return result
    recommended = dict(setting.split("=", 1) for setting in advice["recommended"]["settings"])
    result["recommended"], result["seconds"] = recommended, advice["recommended"]["seconds"]
    result["promised"] = advice["recommended"]["error"]
    own = {**case["settings"], **recommended}
    if STEP not in own:
        own[STEP] = "0.001" if case["kind"] == "ball" else "0.1" if case["kind"] == "strip" else "0.0005"
    # Two levels finer in step and mesh, with the scene's own scheme, element and material.
    reference = finer(finer({**case["settings"], **{name: own[name] for name in own if name == STEP or "/Mesh" in name
                                                    or name.startswith("Mesh/")}}))
    values = {}
    for name, settings in (("advised", own), ("reference", reference)):
        value = value_of(case, scene, settings, folder / name, driver)
        if value is None:
            return dict(result, status="no reference")
        values[name] = value
    result["values"] = values
    exact = 0 if case["quantity"] == "energy error" else values["reference"]
    scale = 1 if case["quantity"] == "energy error" else abs(exact)
    result["error"] = abs(values["advised"] - exact) / scale
    result["kept"] = result["error"] <= case["tolerance"]
    good = [run["seconds"] for run in advice["runs"] if run["good"] and abs(run["values"][0] - exact) / scale
            <= case["tolerance"]]
    result["cheapest_of_grid"] = min(good + [result["seconds"]])
    return result


def value_of(case, scene, settings, folder, driver):
    """Returns the quantity of a run; None if it fails."""
    done = subprocess.run([driver, scene, "--quiet", "--output", folder, "--overwrite"] + sets(settings) +
                          ["--set", "Output/Fields Interval=0", "--set", "Output/Fields Time Interval=0"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None
    rows = list(csv.DictReader(open(folder / "history.csv", encoding="utf-8")))
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return evaluate(case["quantity"], rows, summary)


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
    for status in sorted({case["status"] for case in cases}):
        print(f"{status}: {sum(case['status'] == status for case in cases)}")
    if not advised:
        return
    kept = sum(case["kept"] for case in advised)
    ratios = sorted(case["seconds"] / case["cheapest_of_grid"] for case in advised)
    costs = sorted(case["spent"] / case["seconds"] for case in advised)
    print(f"within the tolerance: {kept} of {len(advised)}")
    print(f"cost over the cheapest run within the tolerance: median {statistics.median(ratios):.2f}, most {ratios[-1]:.2f}")
    print(f"cost of the advice over that of the recommended run: median {statistics.median(costs):.1f}, most {costs[-1]:.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", required=True)
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("advice-cases.results"))
    parser.add_argument("--drivers", type=pathlib.Path, default=ROOT / "build/release/drivers")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    record = options.output / "cases.json"
    done = json.loads(record.read_text(encoding="utf-8")) if record.exists() else {"seed": options.seed, "cases": []}
    if done["seed"] != options.seed:
        sys.exit(f"{record} has the cases of another seed; choose another --output")
    for number in range(options.first, options.first + options.cases):
        if any(case["number"] == number for case in done["cases"]):
            continue
        case = measure(draw(options.seed, number), (options.output / f"case-{number}").resolve(),
                       options.drivers / "ixos-study", options.drivers / "ixos")
        done["cases"].append(case)
        record.write_text(json.dumps(done, indent=1), encoding="utf-8")
        print(json.dumps({key: case[key] for key in ("number", "kind", "quantity", "tolerance", "status", "error",
                                                     "promised", "seconds", "spent") if key in case}), flush=True)
    report(done["cases"])


if __name__ == "__main__":
    main()
