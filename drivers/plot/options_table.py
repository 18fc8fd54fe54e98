#!/usr/bin/python3
"""Prints a Markdown table of the cost of each option of a scene, from a study that switches one option at a time.
Numbers are medians over repeated runs."""
import argparse
import statistics
import sys

from results import ResultsError
from study_results import Study


def table(study, axis, base):
    """The rows of the table: time an iteration and a step to the base's, memory beyond the base's, error."""
    runs = {}
    for run in study.runs.values():
        runs.setdefault(run[axis], []).append(run)
    if base not in runs:
        raise ResultsError(f"{study.folder / 'study.csv'}: {axis} '{base}' does not exist; allowed: {', '.join(runs)}")

    def median(label, value):
        return statistics.median(value(run) for run in runs[label])

    def iteration(run):
        return run["wall_seconds"] / max(run["newton_iterations"], 1)

    def step(run):
        return run["wall_seconds"] / max(run["steps"], 1)

    lines = [f"| {axis} | ms an iteration | to the first | ms a step | to the first | memory, MB | force error |",
             "|---|---|---|---|---|---|---|"]
    for label in runs:
        memory = median(label, lambda run: run["peak_memory_bytes"]) / 1e6
        cells = [label, f"{1000 * median(label, iteration):.3f}",
                 f"{median(label, iteration) / median(base, iteration):.3f}",
                 f"{1000 * median(label, step):.2f}", f"{median(label, step) / median(base, step):.3f}",
                 f"{memory:.0f}", f"{median(label, lambda run: run['error_force']):.1e}"]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", help="results folder of the study")
    parser.add_argument("--axis", default="Option", help="axis whose labels are the rows (default: %(default)s)")
    parser.add_argument("--base", default="as it is",
                        help="label that the others are compared with (default: %(default)s)")
    arguments = parser.parse_args()
    try:
        study = Study(arguments.folder)
        if arguments.axis not in study.axes:
            raise ResultsError(f"{study.folder / 'study.json'}: the axis '{arguments.axis}' does not exist; allowed: "
                               f"{', '.join(study.axes)}")
        print(table(study, arguments.axis, arguments.base))
    except ResultsError as error:
        print(f"options_table.py: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
