#!/usr/bin/python3
"""Measures the limits of stability: runs small scenes over many decades, and writes tables and pictures.

    tests/robustness/extremes/study.py [--only gap,steps] [--output extremes.results] [--images FOLDER]

Every run is classified: completed (with its energy error), failed (exit status 3), refused (2), or what must not be: a
defect (1), a crash, a hang, NaN. The exit status is 1 where something must not be. Runs that were made with the same
driver are not repeated. docs/extremes.md shows what came out; `million` takes some ten minutes on a free
machine, the others minutes.
"""
import argparse
import importlib
import pathlib
import sys

from runs import ROOT, Runner

AXES = ["gap", "law", "catalogue", "obstacles", "pairs", "bounces", "dissipation", "stiffness", "scaling", "density", "step", "impact", "locking", "shapes", "strain", "ranks", "million"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--only", default=",".join(AXES), help="of " + ",".join(AXES))
    parser.add_argument("--driver", default=str(ROOT / "build/release/drivers/ixos"))
    parser.add_argument("--output", default="extremes.results")
    parser.add_argument("--images", default="", help="folder of the pictures (default: that of the output)")
    options = parser.parse_args()
    runner = Runner(options.output, options.driver)
    images = pathlib.Path(options.images or options.output)
    for axis in options.only.split(","):
        lines = importlib.import_module(axis).study(runner, images)
        (runner.folder / f"{axis}.md").write_text("\n".join(lines) + "\n")
        print("\n".join([f"## {axis}", "", *lines, ""]), flush=True)
    sys.exit(1 if runner.defects else 0)


if __name__ == "__main__":
    main()
