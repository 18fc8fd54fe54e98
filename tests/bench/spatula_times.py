#!/usr/bin/env python3
"""Seconds a Newton iteration of xml/spatula.xml takes, by ranks and solver, before it peels.

usage: spatula_times.py BUILD [--cells N] [--steps N]

One row a run: linear solver, ranks, Newton iterations an increment, CG iterations a Newton iteration, seconds a Newton
iteration in all and by phase, peak memory of all ranks. The machine should be idle.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import BENCH_ENVIRONMENT, ROOT, driver_command  # noqa: E402

SOLVERS = {
    "default": [],
    "MUMPS Single, matrix-free": [
        "Preconditioner Type=Direct", "Preconditioner Types/Direct/Solver Type=MUMPS Single", "Operator=Matrix-Free"],
    "MUMPS Single, assembled": [
        "Preconditioner Type=Direct", "Preconditioner Types/Direct/Solver Type=MUMPS Single", "Operator=Assembled"],
    "MUMPS, matrix-free": [
        "Preconditioner Type=Direct", "Preconditioner Types/Direct/Solver Type=MUMPS", "Operator=Matrix-Free"],
    "MueLu, matrix-free": ["Preconditioner Type=MueLu", "Operator=Matrix-Free"],
}


def run(build, scene, solver, ranks, cells, steps):
    end = 0.5 * steps
    settings = [f"Mesh/Spatula/Target Cells={cells}", f"Histories/Pull/Rate Ramp/Length={end}",
                f"Time Integrator/Time Step Control/Final Time={end}", "Output/Checkpoint/Keep=0"]
    if SOLVERS[solver]:
        settings += ["Linear Solver/Linear Solver Type=Belos"] + [f"Linear Solver/{s}" for s in SOLVERS[solver]]
    with tempfile.TemporaryDirectory() as folder:
        command = driver_command(f"{build}/drivers/ixos", scene, ["--output", folder], settings, ranks)
        subprocess.run(command, env=BENCH_ENVIRONMENT, check=True)
        with open(f"{folder}/summary.json", encoding="utf-8") as file:
            return json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--cells", type=int, default=114414)
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--solvers", nargs="+", default=list(SOLVERS), choices=SOLVERS)
    arguments = parser.parse_args()
    scene = os.path.join(ROOT, "xml/spatula.xml")
    print("| solver | ranks | Newton/increment | CG/Newton | s/Newton | residual | tangent | factorization | linear solve "
          "| memory, GB |\n|---|---|---|---|---|---|---|---|---|---|")
    for solver in arguments.solvers:
        for ranks in arguments.ranks:
            result = run(arguments.build, scene, solver, ranks, arguments.cells, arguments.steps)
            newton = result["newton_iterations"]
            phases = [f'{result["seconds"][phase] / newton:.3f}'
                      for phase in ("residual", "tangent", "factorization", "linear solve")]
            print(f'| {solver} | {ranks} | {newton / result["steps"]:.2f} | {result["linear_iterations"] / newton:.1f} '
                  f'| {result["wall_seconds"] / newton:.3f} | {" | ".join(phases)} '
                  f'| {result["peak_memory_bytes"] / 1e9:.2f} |', flush=True)


if __name__ == "__main__":
    main()
