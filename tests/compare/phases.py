#!/usr/bin/python3
"""Times the parts of a Newton iteration of two builds of Ixos, their runs in turn.

    tests/compare/phases.py --before BUILD [--after BUILD] [--rounds 5]

It runs the ball (composite scheme, average vector field) and the strip to 57 T0 and prints, for each, the ratios of the
medians of residual, tangent and their sum, and the microseconds that an iteration takes beside the phases of
summary.json: NOX, Thyra, the integrator. Nothing else should run meanwhile.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

from bitwise import call
from driver_process import ROOT

FORMS = {"ball": ("xml/ball.xml", ["Time Integrator/Type=Gautam-Sauer Composite"]),
         "ball, Average Vector Field": ("xml/ball.xml", ["Time Integrator/Type=Average Vector Field"]),
         "strip": ("xml/strip.xml", ["Time Integrator/Time Step Control/Final Time=57",
                                     "Output/Fields Time Interval=0"])}


def measure(build, scene, settings, folder):
    """Runs a scene. Returns the seconds of residuals and tangents and the other seconds of the time loop, all over the
    number of Newton iterations."""
    command = [str(build / "drivers/ixos"), str(ROOT / scene), "--output", "results", "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    status, output = call(build, command, folder)
    if status != 0:
        raise RuntimeError(f"{scene}: exit status {status}: {output}")
    summary = json.loads((folder / "results/summary.json").read_text())
    phases = summary["seconds"]
    rest = summary["wall_seconds"] - sum(phases.values())
    return [value / summary["newton_iterations"] for value in (phases["residual"], phases["tangent"], rest)]


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--before", required=True, type=pathlib.Path, help="folder of a build")
    parser.add_argument("--after", default=ROOT / "build/release", type=pathlib.Path, help="folder of a build")
    parser.add_argument("--rounds", default=5, type=int, help="runs of each build (default: %(default)s)")
    arguments = parser.parse_args()
    builds = [arguments.before.resolve(), arguments.after.resolve()]
    print("| scene | residual | tangent | both | the rest before, us | after, us |\n|---|---|---|---|---|---|")
    try:
        for name, (scene, settings) in FORMS.items():
            times = [[], []]
            for _ in range(arguments.rounds):
                for build, found in zip(builds, times):
                    with tempfile.TemporaryDirectory() as folder:
                        found.append(measure(build, scene, settings, pathlib.Path(folder)))
            before, after = ([statistics.median(column) for column in zip(*found)] for found in times)
            both = sum(after[:2]) / sum(before[:2])
            print(f"| {name} | {after[0] / before[0]:.3f} | {after[1] / before[1]:.3f} | {both:.3f} "
                  f"| {1e6 * before[2]:.1f} | {1e6 * after[2]:.1f} |", flush=True)
    except (RuntimeError, OSError, subprocess.SubprocessError) as error:
        print(f"phases.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
