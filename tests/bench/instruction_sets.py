#!/usr/bin/python3
"""Measures what the instruction sets of a portable build cost against a build for this processor.

    tests/bench/instruction_sets.py --native build/release --portable build/portable [--rounds 5]

Runs short forms of the ball (2D), the strip (2D) and the block on a wall (3D, matrix-free) with the library of each
build in turn, and prints the least processor time of the rounds and its ratio to the native build's. The builds are
compared side by side, so another load of the machine disturbs all of them alike.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../compare"))
from forms import FINAL, RAMP, SMALL_BLOCK, STEPS, XML  # noqa: E402

LOADER = "/lib64/ld-linux-x86-64.so.2"
SCENES = {
    "ball": ("ball.xml", [FINAL + "10"]),
    "strip": ("strip.xml", [RAMP + "2", FINAL + "20"]),
    "block, matrix-free": ("block-on-wall.xml",  # short steps, for which the solver is matrix-free
                           [*SMALL_BLOCK, STEPS + "Time Step=0.005", RAMP + "0.1", FINAL + "1.5"]),
}
MASKS = {"x86-64-v4": "x86-64-v4", "x86-64-v3": "x86-64-v3", "x86-64": "none"}


def run(command, folder):
    """Returns the processor time of a command in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([*command, "--quiet", "--output", folder, "--overwrite"], check=True,
                   env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--native", type=pathlib.Path, required=True, help="folder of the build for this processor")
    parser.add_argument("--portable", type=pathlib.Path, required=True, help="folder of the portable build")
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    programs = {"native": [arguments.native / "drivers/ixos"]}
    for name, mask in MASKS.items():
        programs[name] = [LOADER, "--glibc-hwcaps-mask", mask, arguments.portable / "drivers/ixos"]
    print("| scene | native | " + " | ".join(f"{name} | ratio" for name in MASKS) + " |")
    print("|---|---|" + "---|---|" * len(MASKS))
    with tempfile.TemporaryDirectory() as folder:
        for scene, (file, settings) in SCENES.items():
            sets = [word for setting in settings for word in ("--set", setting)]
            least = {}
            for _ in range(arguments.rounds):
                for name, program in programs.items():
                    seconds = run([*program, XML / file, *sets], os.path.join(folder, "run"))
                    least[name] = min(seconds, least.get(name, seconds))
            cells = [f"{least[name]:.2f} s | {least[name] / least['native']:.3f}" for name in MASKS]
            print(f"| {scene} | {least['native']:.2f} s | " + " | ".join(cells) + " |", flush=True)


main()
