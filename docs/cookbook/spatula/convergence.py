#!/usr/bin/python3
"""Peels the pad of xml/spatula.xml, on meshes and in steps that are coarser and finer than those of study.py: how many
faces the cohesive zone needs, how many cells across and through the pad, and how long a step may be. Average Vector
Field, until the pad is free. Finished runs are not repeated.

    docs/cookbook/spatula/convergence.py [--results FOLDER] [--scales 0.25 1]
    docs/cookbook/spatula/convergence.py --measure FOLDER...      the smooth peak and the ripple of other runs"""
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
STEPS = (1.0, 0.5, 0.25)
# Window of a force's smooth part, the lifts of its ripple, and those of the late peak: of the full pad [nm].
WINDOW, BETWEEN, LATE_LIFTS = 30.0, (50.0, 157.0), (115.0, 207.0)
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
    """Returns the oscillation of the force as the front passes the pad, over its mean there [-]."""
    lift, force = study.curve(run, scale)
    return measures.oscillation(lift, force, BETWEEN, WINDOW)[1]


def smooth_peak(run, scale):
    """Returns the largest value of the force's smooth part late in the peeling [nN], and its lift [nm].

    It needs the force to a lift of half a window beyond; a run that ends before counts as far as it got."""
    lift, force = study.curve(run, scale)
    lifts = LATE_LIFTS[0], min(LATE_LIFTS[1], lift[-1] - WINDOW / 4)
    smooth = measures.smooth(lift, force, lifts, WINDOW)
    top = int(np.nanargmax(smooth))
    return smooth[top], lift[recipe.results.within(lift, lifts)][top]


def report(folders):
    """Prints the smooth peak and the ripple of runs of any size."""
    rows = []
    for folder in folders:
        run = recipe.results.Run(folder)
        scale = float(run.setting("Mesh/Spatula/Pad Length")) / LATE["Pad Length"]
        peak, lift = smooth_peak(run, scale)
        rows.append([f"{scale:g}", f"{run.time_step:g}", f"{run['time'][-1] / scale:.0f}", f"{peak:.2f}",
                     f"{lift:.0f}", f"{100 * ripple(run, scale):.2f} %"])
    recipe.table(["size of the pad", "step [T0]", "run to [T0 / size]", "late peak, smooth [nN]", "at [nm]", "ripple"],
                 rows)


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
                     f"{smooth_peak(run, scale)[0]:.2f}", f"{found['late'][1]:.0f}", f"{found['free']:.0f}",
                     f"{found['work']:.0f}", f"{100 * ripple(run, scale):.2f} %", f"{found['iterations']:.1f}"])
    print(f"\nscale {scale:g}\n")
    recipe.table(["changed", "faces in the cohesive zone", "cells across", "step [T0]", "cells", "first peak [nN]",
                  "at [nm]", "late peak [nN]", "smooth", "at [nm]", "free at [nm]", "work [E0 L0^3]", "ripple",
                  "Newton/increment"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("results/cookbook/spatula/convergence"),
                        help="folder of the results of all runs (default: %(default)s)")
    parser.add_argument("--scales", type=float, nargs="+", default=[0.25], choices=list(study.MESHES),
                        help="sizes of the pad (default: 0.25)")
    parser.add_argument("--finished", action="store_true", help="no new runs: only those that are finished")
    parser.add_argument("--measure", type=pathlib.Path, nargs="+", metavar="FOLDER", help="only measure these results")
    arguments = parser.parse_args()
    if arguments.measure:
        report(arguments.measure)
        return
    for scale in arguments.scales:
        compare(arguments.results, scale, arguments.finished)


if __name__ == "__main__":
    main()
