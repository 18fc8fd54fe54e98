#!/usr/bin/python3
"""Peels the pad of xml/spatula.xml with four schemes: the full pad to its release and 60 T0 beyond, then pads on which
each scheme runs with the iteration of Ixos and with Newton's method alone. Finished runs are not repeated.

    docs/cookbook/spatula/schemes.py [--results FOLDER] [--only schemes|iterations] [--scale 0.5]"""
import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402
import measures  # noqa: E402 (of drivers/plot)
from exodus import Fields  # noqa: E402

study = recipe.study("spatula")
LATE = study.beam.LATE
SCHEMES = ("Average Vector Field", "Gautam-Sauer Composite", "Bathe Composite", "Newmark")
END = 290.0  # 60 T0 after the release of the full pad [T0]
DIRECT = {"Linear Solver/Linear Solver Type": "Direct"}
ALONE = {"Nonlinear Solver/NOX/Direction/Method": "Newton", "Nonlinear Solver/NOX/Line Search/Method": "Full Step",
         **DIRECT}
ITERATIONS = {"Ixos": {}, "Ixos, Direct": DIRECT, "Newton's method alone": ALONE}
RANGE = (-0.125, 0.25)  # of the colours in the paper's figure 17
FRAMES = (0, 30, 60, 100, 140, 170, 200, 220, 230)
# Faces in the cohesive zone of the pads that compare iterations: the front jumps, and moves smoothly.
FACES = (1, 3)
STEPS = (0.5, 1.0)


def named(scheme, rest):
    """Returns the name of a run's folder."""
    return "-".join([*scheme.lower().split(), rest])


def whole(scheme, scale):
    """Returns the settings of a run beyond the release, with pictures and checkpoints."""
    settings = study.settings(LATE, scale)
    for name in ("Time Integrator/Stop/Free/Type", *recipe.QUIET):
        del settings[name]
    return {**settings, "Time Integrator/Type": scheme, recipe.STEPS + "Final Time": END * scale,
            "Output/Fields Time Interval": 10.0 * scale}


def error_of_balance(run, rows):
    """Returns the largest error of the energy balance over the work, of some rows."""
    return run.energy_error()[rows].max() / run["external_work"].max()


def peeled(run, scale):
    """Returns the cells of force and work."""
    return study.cells(study.measured(run, scale, LATE))


def swung(run, scale):
    """Returns the cells of energy: when the wall lets go, kinetic energy from then on, error of the balance over the
    work until then and in all."""
    times, kinetic = run["time"], run["kinetic_energy"] / scale**2
    free = measures.detachment(times, run["contact_measure"])
    after = np.flatnonzero(times >= free)
    top = after[kinetic[after].argmax()]

    def mean(start, end):
        rows = recipe.results.within(times, (free + start * scale, free + end * scale))
        return measures.mean(times[rows], kinetic[rows])

    return [f"{free / scale:.1f}", f"{kinetic[top]:.1f}", f"{times[top] / scale:.1f}", f"{mean(0, 20):.2f}",
            f"{mean(40, 60):.2f}", f"{error_of_balance(run, times < free):.0e}",
            f"{error_of_balance(run, times >= 0):.0e}"]


def spent(run, scale):
    """Returns the cells of cost: Newton iterations an increment, mean until the wall lets go, their largest number, and
    mean from then on; seconds an increment and an iteration."""
    bonded = run["contact_measure"][1:] > 0
    iterations = run["newton_iterations"][1:]
    seconds = run["wall_seconds"][-1] - run["wall_seconds"][0]
    return [f"{iterations[bonded].mean():.1f}", f"{iterations.max():.0f}", f"{iterations[~bonded].mean():.1f}",
            f"{seconds / len(iterations):.2f}", f"{seconds / iterations.sum():.2f}"]


TABLES = (
    (peeled, study.COLUMNS),
    (swung, ["detached at [T0]", "largest kinetic energy after it [E0 L0^3]", "at [T0]", "mean, 0 to 20 T0 after it",
             "mean, 40 to 60 T0 after it", "error of the balance / work until then", "in all"]),
    (spent, ["Newton/increment, peeling", "largest", "free", "s/increment", "s/iteration"]))


def compare_schemes(folder, scale, finished):
    """Prints the tables of the schemes on the whole pad."""
    runs = {}
    for scheme in SCHEMES:
        path = folder / named(scheme, f"{scale:g}")
        if study.is_finished(path):
            runs[scheme] = recipe.results.Run(path)
        elif not finished:
            runs[scheme] = recipe.run("spatula", whole(scheme, scale), path)
    for cells, columns in TABLES:
        print()
        recipe.table(["scheme", *columns], [[scheme, *cells(run, scale)] for scheme, run in runs.items()])


def compare_stresses(folder, scale, times):
    """Prints the range of the first stress invariant over E, at those times of the full pad [T0] that a run reached."""
    path = folder / named(SCHEMES[0], f"{scale:g}")
    if not (path / "fields.e").exists():
        return
    fields, rows = Fields(path), []
    for time in [time for time in times if time * scale <= fields.times[-1]]:
        values = fields.element("first_stress_invariant", fields.nearest_frame(time * scale))
        rows.append([time, f"{values.min():.3f}", f"{values.max():.3f}",
                     f"{100 * np.mean((values < RANGE[0]) | (values > RANGE[1])):.2f} %"])
    print()
    recipe.table(["time [T0]", "least", "largest", "cells beyond the paper's colours"], rows)


def has_ended(folder):
    """Returns whether a folder has a run that reached its end or diverged."""
    summary = folder / "summary.json"
    return study.is_finished(folder) or summary.exists() and '"diverged"' in summary.read_text(encoding="utf-8")


def outcome(folder, settings):
    """Runs settings unless the folder has a run. Returns where it ended, and its Newton iterations an increment."""
    if not has_ended(folder):
        try:
            recipe.run("spatula", settings, folder)
        except RuntimeError:
            pass  # it diverges: its results say where
    run = recipe.results.Run(folder)
    steps = run.summary["steps"]
    each = f"{run.summary['newton_iterations'] / max(steps, 1):.1f} an increment"
    if run.summary["status"] == "stopped":
        return f"free at {run['time'][-1]:g} T0, {each}"
    return f"{run.summary['status']} after {run['time'][-1]:g} T0, {each}"


def compare_iterations(folder, finished, scale=0.25):
    """Prints the table of schemes with the iteration of Ixos and Newton's method alone."""
    rows = []
    across = study.MESHES[scale][1]
    for faces in FACES:
        for step in STEPS:
            for scheme in SCHEMES:
                rows.append([f"{faces:g}", f"{step:g}", scheme])
                for name, changes in ITERATIONS.items():
                    path = folder / "iterations" / named(scheme, f"{name.split()[-1].lower()}-{faces:g}-{step:g}")
                    settings = study.settings(LATE, scale, step, (study.cohesive_zone(scale) / faces, across))
                    if finished and not has_ended(path):
                        rows[-1].append("not run")
                        continue
                    rows[-1].append(outcome(path, {**settings, "Time Integrator/Type": scheme, **changes}))
    print()
    recipe.table(["faces in the cohesive zone", "step [T0]", "scheme", *ITERATIONS], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("results/cookbook/spatula"),
                        help="folder of the results of all runs (default: %(default)s)")
    parser.add_argument("--only", choices=["schemes", "iterations"], help="one part")
    parser.add_argument("--scale", type=float, default=1.0, choices=list(study.MESHES),
                        help="size of the pad that compares the schemes (default: 1)")
    parser.add_argument("--finished", action="store_true", help="no new runs: only those that are finished")
    arguments = parser.parse_args()
    if arguments.only in (None, "schemes"):
        compare_schemes(arguments.results, arguments.scale, arguments.finished)
        compare_stresses(arguments.results, arguments.scale, FRAMES)
    if arguments.only in (None, "iterations"):
        compare_iterations(arguments.results, arguments.finished)


if __name__ == "__main__":
    main()
