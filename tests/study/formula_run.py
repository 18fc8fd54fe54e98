#!/usr/bin/python3
"""A stand-in for the program ixos: a run whose results are a formula of its settings.

    IXOS_FORMULA='...' formula_run.py SCENE --quiet --output FOLDER --overwrite --set "Path=value"...

IXOS_FORMULA is an expression in Python: the value of the column "force" at the time t, and at the end the energy error.
It may use t; dt, the step; h, 8 over the number of cells along the box; dimension; scheme; element; material; tolerance,
of Newton's method; change, the relative change of the density; sin, min and max. If it is negative at the end, the run
diverges. So it does at the time IXOS_FAILURE, another such expression, if that is not 0: there are no rows after it.

IXOS_STRAINS has the largest rotation and the extreme strains at the end, "0.1,-0.01,0.02", which grow in proportion to
t; rows have them if the scene asks for them. Each run adds a line to the file runs.txt beside the scene. Processor time
grows with steps and cells.
"""
import json
import math
import os
import pathlib
import re
import sys

DENSITY = 5e-7
ROWS = 20


def main():
    arguments = sys.argv[1:]
    scene = pathlib.Path(arguments[0])
    folder = pathlib.Path(arguments[arguments.index("--output") + 1])
    settings = dict(arguments[i + 1].split("=", 1) for i, word in enumerate(arguments) if word == "--set")
    names = {path.rsplit("/", 1)[-1]: value for path, value in settings.items()}
    dt = float(names.get("Time Step", 0.1))
    divisions = re.findall(r"\d+", names.get("Divisions", "{8, 8}"))
    cells = int(divisions[0])
    scheme = settings.get("Time Integrator/Type", "Newmark")
    end = float(names.get("Final Time", 10))
    with open(scene.parent / "runs.txt", "a", encoding="utf-8") as file:
        file.write(folder.name + "\n")
    values = {"dt": dt, "h": 8 / cells, "dimension": len(divisions), "scheme": scheme, "element": names.get("Contact Element", "Q1C1"),
              "tolerance": float(settings.get("Nonlinear Solver/Tolerance", 1e-11)),
              "material": names.get("Model", "Neo-Hooke"), "change": float(names.get("Density", DENSITY)) / DENSITY - 1,
              "sin": math.sin, "min": min, "max": max}

    def evaluated(variable, time):
        return eval(os.environ.get(variable, "0"), {"__builtins__": {}}, {**values, "t": time})

    failure = evaluated("IXOS_FAILURE", 0)
    value = evaluated("IXOS_FORMULA", end)
    good = value >= 0 and not failure
    steps = math.ceil(end / dt)
    total = 0.0
    for i in range(steps * cells * cells // 100):
        total += i
    measured = settings.get("Output/Strains") == "true"
    strains = [float(each) for each in os.environ.get("IXOS_STRAINS", "0,0,0").split(",")]
    header = "step,time,time_step,force,kinetic_energy,wall_seconds"
    rows = header + ",largest_rotation,least_strain,largest_strain" * measured + "\n"
    for n in range(ROWS + 1):
        time = n * end / ROWS
        if failure and time > failure:
            break
        more = [time / end * each for each in strains] if measured else []
        rows += ",".join(repr(each) for each in (n, time, dt, evaluated("IXOS_FORMULA", time), 1.0, 1e-3, *more)) + "\n"
    (folder / "history.csv").write_text(rows)
    (folder / "effective.xml").write_text(
        f'<ParameterList name="x"><ParameterList name="Time Integrator"><Parameter name="Type" type="string" '
        f'value="{scheme}"/></ParameterList></ParameterList>')
    (folder / "summary.json").write_text(json.dumps({
        "status": "completed" if good else "diverged",
        "reason": "" if good else f"failed at {failure}" if failure else "negative", "steps": steps,
        "dofs": 2 * (cells + 1) ** 2, "wall_seconds": 1e-7 * steps * cells * cells, "max_energy_error": abs(value)}))
    sys.exit(0 if good else 3)


if __name__ == "__main__":
    main()
