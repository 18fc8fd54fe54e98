#!/usr/bin/python3
"""A stand-in for the program ixos: a run whose results are a formula of its settings.

    IXOS_FORMULA='...' formula_run.py SCENE --quiet --output FOLDER --overwrite --set "Path=value"...

IXOS_FORMULA is an expression in Python: the value of the column "force", and the energy error. It may use dt, the step;
h, 8 over the number of cells along the box; dimension; scheme; element; tolerance, of Newton's method; change, the relative
change of the density; sin and min. If it is negative, the run diverges. Each run adds a line to the file runs.txt beside
the scene. Processor time grows with steps and cells.
"""
import json
import math
import os
import pathlib
import re
import sys

DENSITY = 5e-7


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
              "change": float(names.get("Density", DENSITY)) / DENSITY - 1, "sin": math.sin, "min": min}
    value = eval(os.environ["IXOS_FORMULA"], {"__builtins__": {}}, values)
    steps = math.ceil(end / dt)
    total = 0.0
    for i in range(steps * cells * cells // 100):
        total += i
    rows = "".join(f"{n},{n * end / 2},{dt},{value!r},1.0,1e-3\n" for n in range(3))
    (folder / "history.csv").write_text("step,time,time_step,force,kinetic_energy,wall_seconds\n" + rows)
    (folder / "effective.xml").write_text(
        f'<ParameterList name="x"><ParameterList name="Time Integrator"><Parameter name="Type" type="string" '
        f'value="{scheme}"/></ParameterList></ParameterList>')
    (folder / "summary.json").write_text(json.dumps({
        "status": "completed" if value >= 0 else "diverged", "reason": "" if value >= 0 else "negative", "steps": steps,
        "dofs": 2 * (cells + 1) ** 2, "wall_seconds": 1e-7 * steps * cells * cells, "max_energy_error": abs(value)}))
    sys.exit(0 if value >= 0 else 3)


if __name__ == "__main__":
    main()
