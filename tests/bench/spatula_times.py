#!/usr/bin/env python3
"""Seconds a Newton iteration of xml/spatula-stiff.xml takes, by ranks and solver, before it peels.

usage: spatula_times.py BUILD [--cells N] [--steps N]

One row a run: linear solver, ranks, Newton iterations an increment, CG iterations a Newton iteration, seconds a Newton
iteration in all and by phase, peak memory of all ranks. The machine should be idle.
"""
import argparse

from newton_times import COLUMNS, figures, header, row, run, spatula

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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--cells", type=int, default=114414)
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--solvers", nargs="+", default=list(SOLVERS), choices=SOLVERS)
    arguments = parser.parse_args()
    scene, settings = spatula(arguments.cells, arguments.steps)
    header("solver", "ranks", *COLUMNS)
    for solver in arguments.solvers:
        chosen = ["Linear Solver/Linear Solver Type=Belos"] if SOLVERS[solver] else []
        chosen += [f"Linear Solver/{setting}" for setting in SOLVERS[solver]]
        for ranks in arguments.ranks:
            row(solver, ranks, *figures(run(arguments.build, scene, settings + chosen, ranks)))


if __name__ == "__main__":
    main()
