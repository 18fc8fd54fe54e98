#!/usr/bin/env python3
"""Seconds a Newton iteration of xml/block-on-wall.xml takes: 107,811 degrees of freedom under van der Waals load.

usage: block_times.py BUILD [--divisions N] [--steps N] [--step T0...] [--ranks N...] [--repeats N] [--set PATH=VALUE...]

One row a run: degrees of freedom, step, ranks, Newton iterations an increment and in all, CG iterations a Newton iteration,
seconds a Newton iteration in all and by phase, peak memory of all ranks. The machine should be idle.
"""
import argparse

from newton_times import COLUMNS, block, figures, header, row, run


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--divisions", type=int, default=32, help="hexahedra a direction")
    parser.add_argument("--steps", type=int, default=8)
    parser.add_argument("--step", type=float, nargs="+", default=[0.5], help="T0")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1])
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="a change of the scene")
    arguments = parser.parse_args()
    header("degrees of freedom", "step, T0", "ranks", "Newton", *COLUMNS)
    for step in arguments.step:
        scene, settings = block([arguments.divisions] * 3, arguments.steps, step)
        for ranks in arguments.ranks:
            for _ in range(arguments.repeats):
                result = run(arguments.build, scene, settings + arguments.set, ranks)
                row(f'{result["dofs"]:,}', step, ranks, result["newton_iterations"], *figures(result))


if __name__ == "__main__":
    main()
