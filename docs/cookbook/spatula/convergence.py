#!/usr/bin/python3
"""Peels the pad of xml/spatula.xml, on meshes and in steps that are coarser and finer than those of study.py: how many
faces the cohesive zone needs, how many cells across and through the pad, and how long a step may be. Average Vector
Field, until the pad is free. Finished runs are not repeated.

    docs/cookbook/spatula/convergence.py [--results FOLDER] [--scales 0.25 1]"""
import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402
import measures  # noqa: E402 (of drivers/plot)

study = recipe.study("spatula")
LATE = study.beam.LATE
FACES = (1, 1.5, 3, 6)  # in the cohesive zone
STEPS = (2.0, 1.0, 0.5, 0.25)
# Window of the ripple's smooth part, and the range of lifts between the peaks where it is taken: of the full pad [nm].
WINDOW, BETWEEN = 44.0, (50.0, 120.0)
LAYERS = {"Mesh/Spatula/Core Layers": 2, "Mesh/Spatula/Rings": 2}
ENHANCED = {"Materials/Keratin/Element Formulation": "Enhanced"}
ENRICHED = {"Interactions/Wall/Contact Element": "Q1C2"}


def variants(scale):
    """Yields the cells that name a run, faces in the cohesive zone, cells across, time step and further changes."""
    across = study.MESHES[scale][1]
    for faces in FACES:
        yield "faces", faces, across, 0.5, {}
    for faces in FACES[:2]:
        yield "faces, Q1C2", faces, across, 0.5, ENRICHED
    yield "across", 3, 2 * across, 0.5, {}
    yield "layers, 6", 3, across, 0.5, LAYERS
    yield "Enhanced", 3, across, 0.5, ENHANCED
    for step in STEPS:
        if step != 0.5:
            yield "step", 3, across, step, {}


def ripple(run, scale):
    """Returns the oscillation of the force between its peaks over its mean there [-]."""
    lift, force = study.curve(run, scale)
    return measures.oscillation(lift, force, BETWEEN, WINDOW)[1]


def compare(folder, scale, finished):
    """Prints the table of a size of the pad."""
    rows = []
    for name, faces, across, step, changes in variants(scale):
        path = folder / f"{name.replace(', ', '-').lower()}-{faces:g}-{step:g}-{scale:g}"
        if finished and not study.is_finished(path):
            continue
        mesh = (study.cohesive_zone(scale) / faces, across)
        run = study.peel(LATE, scale, path, changes, step, mesh)
        found = study.measured(run, scale, LATE)
        rows.append([name, f"{faces:g}", across, f"{step:g}", f"{run.summary['elements']:,}",
                     f"{found['first'][0]:.2f}", f"{found['first'][1]:.0f}", f"{found['late'][0]:.2f}",
                     f"{found['late'][1]:.0f}", f"{found['free']:.0f}", f"{found['work']:.0f}",
                     f"{100 * ripple(run, scale):.1f} %", f"{found['iterations']:.1f}"])
    print(f"\nscale {scale:g}\n")
    recipe.table(["changed", "faces in the cohesive zone", "cells across", "step [T0]", "cells", "first peak [nN]",
                  "at [nm]", "late peak [nN]", "at [nm]", "free at [nm]", "work [E0 L0^3]", "ripple",
                  "Newton/increment"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("results/cookbook/spatula/convergence"),
                        help="folder of the results of all runs (default: %(default)s)")
    parser.add_argument("--scales", type=float, nargs="+", default=[0.25], choices=list(study.MESHES),
                        help="sizes of the pad (default: 0.25)")
    parser.add_argument("--finished", action="store_true", help="no new runs: only those that are finished")
    arguments = parser.parse_args()
    for scale in arguments.scales:
        compare(arguments.results, scale, arguments.finished)


if __name__ == "__main__":
    main()
