#!/usr/bin/python3
"""Peels spatulae of several shapes, on pads of a quarter of the size, and compares them with the beam of reference.py:
four shapes, then that of xml/spatula.xml with one parameter changed by 20 per cent, then two with a shaft's end that
is held or free. Finished runs are not repeated.

    docs/cookbook/spatula/study.py [--results FOLDER] [--only shapes|parameters|ends]"""
import argparse
import json
import math
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as beam  # noqa: E402

RAMP = 20.0  # of the pull, on the full pad [T0]
NANONEWTONS = 2.0  # in E0 L0^2
GROWTH = 5.0  # cell length in the shaft over that in the pad
# Length of a contact face and cells across, by scale: at least three faces in the cohesive zone.
MESHES = {0.25: (0.7, 12), 0.5: (1.0, 16), 1.0: (1.4, 20)}
SHAPES = {name: beam.SHAPES[name] for name in ("stiff", "thin", "narrow", "late")}
# A pad of a quarter of the size is thick for its length: its transition would sink below the underside.
MISFIT = "Fillet Radius", 1.2


def cohesive_zone(scale):
    """Returns the length of the cohesive zone of a scaled pad [nm]: that of 5 nm is 5 s^(2/3) nm thick."""
    return 4.4 * scale**0.5


def settings(shape, scale, step=0.5, mesh=None):
    """Returns the settings of a run until the pad is free.

    shape: of the full size; lengths are scaled here. mesh: length of a contact face [nm] and cells across, if they are
    not those of MESHES."""
    face, columns = mesh or MESHES[scale]
    small = beam.scaled(shape, scale)
    along = small["Pad Length"] + small["Transition Length"] * math.log(GROWTH) / (GROWTH - 1) \
        + small["Shaft Length"] / GROWTH
    mesh = {**small, "Core Cells": columns, "Core Layers": 1, "Rings": 1, "Tip Rows": columns // 4, "Growth": GROWTH,
            "Stations": round(along / face)}
    return {**recipe.QUIET, **{"Mesh/Spatula/" + name: value for name, value in mesh.items()},
            "Output/Probes/P/Point": [small["Pad Length"], 0.0, recipe.EQUILIBRIUM_GAP],
            "Histories/Pull/Rate Ramp/Length": RAMP * scale, "Time Integrator/Type": "Average Vector Field",
            "Time Integrator/Stop/Free/Type": "Detached", recipe.STEPS + "Time Step": step,
            recipe.STEPS + "Final Time": 600.0 * scale}


def is_finished(folder):
    """Returns whether a folder has a run that reached its end or was stopped by its criterion."""
    summary = folder / "summary.json"
    return summary.exists() and json.loads(summary.read_text(encoding="utf-8"))["status"] in ("completed", "stopped")


def peel(shape, scale, folder, changes=None, step=0.5, mesh=None):
    """Runs a shape, unless the folder has the finished run."""
    if is_finished(folder):
        return recipe.results.Run(folder)
    return recipe.run("spatula", {**settings(shape, scale, step, mesh), **(changes or {})}, folder)


def freed(end, shape, scale):
    """Returns the settings that free the shaft's end. The nodes on the section's line along y make a hinge."""
    if end == "free along x":
        return {"Boundary Conditions/Guide/Components": "y"}
    line = beam.Centreline(beam.scaled(shape, scale), scale)
    x, z, width, near = line.x[0], line.z[0], line.width[0], 0.02 * scale
    hinge = {"Kind": "Nodes", "Lower": [x - near, -width, z - near], "Upper": [x + near, width, z + near]}
    return {**{"Mesh/Sets/hinge/" + name: value for name, value in hinge.items()}, "Mesh/Spatula/Core Layers": 2,
            "Boundary Conditions/Guide/Node Set": "hinge", "Boundary Conditions/Pull/Node Set": "hinge",
            "Output/Reactions": "{hinge}"} if end == "free to turn" else {}


def curve(run, scale):
    """Returns lift [nm] and force [nN] of a run as those of the full pad. A step's mean force has the step's middle."""
    _, times, force = run.reaction()
    return run.applied(times) / scale, NANONEWTONS * force / scale


def measured(run, scale, shape):
    """Returns the measures of a run as those of the full pad: forces in nN, lifts in nm, work in E0 L0^3."""
    found = beam.measures(*curve(run, scale), shape["Pad Length"])
    return found | {
        "work": run["external_work"][-1] / scale**2, "balance": balance(run), "iterations":
        run["newton_iterations"].sum() / run["step"][-1]}


def predicted(name, scale=1.0, end="held"):
    """Returns the same of the beam, from reference.csv. None: reference.py does not print it."""
    for row in recipe.reference("spatula"):
        if (row["shape"], row["end"], row["scale"]) == (name, end, scale):
            return {peak: (NANONEWTONS * row[peak], row[peak + "_lift"]) for peak in ("first", "late")} | {
                "trough": (NANONEWTONS * row["trough"],), "free": row["free"], "work": row["work"]}
    return None


def balance(run):
    """Returns the largest error of the energy balance over the work."""
    error = run["total_energy"] - run["external_work"] + run["dissipated_energy"]
    return abs(error - error[0]).max() / run["external_work"].max()


def cells(found):
    """Returns the cells of a table: both peaks with their lifts, the least force between, lift of release, work."""
    first, late = found["first"], found["late"]
    return [f"{first[0]:.2f}", f"{first[1]:.0f}", f"{found['trough'][0]:.2f}", f"{late[0]:.2f}", f"{late[1]:.0f}",
            f"{found['free']:.0f}", f"{found['work']:.0f}"]


COLUMNS = ["first peak [nN]", "at [nm]", "least between [nN]", "late peak [nN]", "at [nm]", "free at [nm]",
           "work [E0 L0^3]"]


def compare_shapes(folder, scales, step, finished):
    """Prints the table of shapes. Returns the curves at the first scale."""
    rows, curves = [], {}
    for name, shape in SHAPES.items():
        rows.append([name, "beam, full size", *cells(predicted(name)), "", ""])
        for scale in scales:
            path = folder / (f"{name}-{scale:g}" + (f"-step-{step:g}" if step != 0.5 else ""))
            if predicted(name, scale) and scale != 1:
                rows.append([name, f"beam, scale {scale:g}", *cells(predicted(name, scale)), "", ""])
            if finished and not is_finished(path):
                continue
            run = peel(shape, scale, path, step=step)
            found = measured(run, scale, shape)
            rows.append([name, f"Ixos, scale {scale:g}", *cells(found), f"{100 * found['balance']:.2f} %",
                         f"{found['iterations']:.1f}"])
            if scale == scales[0]:
                curves[name] = curve(run, scale)
    recipe.table(["shape", "model", *COLUMNS, "error of the balance / work", "Newton/increment"], rows)
    return curves


def changed(folder, name, factor):
    """Returns the folder of the run with a parameter changed by a factor."""
    return folder / f"{name.replace(' ', '-').lower()}{factor - 1:+.1f}"


def compare_parameters(folder, finished, scale=0.25):
    """Prints the table of changed parameters. Returns the beam's and Ixos' peaks by name and factor."""
    shapes = {("none", 1.0): beam.LATE} | {(name, factor): shape for name, factor, shape in beam.varied()}
    model, found, rows = {}, {}, []
    for row in recipe.reference("spatula", "parameters.csv"):
        key = row["parameter"], row["factor"]
        model[key] = {peak: NANONEWTONS * row[peak] for peak in ("first", "late")}
        rows.append([key[0] + (f" {100 * key[1] - 100:+.0f} %" if key[1] != 1 else ""),
                     *(f"{model[key][peak]:.2f}" for peak in ("first", "late")),
                     *(f"{row[column]:.0f}" for column in ("late_lift", "work"))])
        if key == MISFIT or finished and not is_finished(changed(folder, *key)):
            rows[-1] += ["does not fit" if key == MISFIT else "not run"] + 3 * [""]
            continue
        pad = measured(peel(shapes[key], scale, changed(folder, *key), step=1.0), scale, shapes[key])
        found[key] = {peak: pad[peak][0] for peak in ("first", "late")}
        rows[-1] += [*(f"{found[key][peak]:.2f}" for peak in ("first", "late")), f"{pad['late'][1]:.0f}",
                     f"{pad['work']:.0f}"]
    print()
    recipe.table(["changed"] + 2 * ["first peak [nN]", "late peak [nN]", "at [nm]", "work [E0 L0^3]"], rows)
    return model, found


def compare_ends(folder, finished, scale=0.25):
    """Prints the table of what the shaft's end may do."""
    rows = []
    for name in ("thin", "late"):
        for end in beam.ENDS:
            rows.append([name, end, "beam, full size", *cells(predicted(name, end=end))])
            path = folder / (f"{name}-{scale:g}" + ("" if end == "held" else "-" + end.split()[-1]))
            if not finished or is_finished(path):
                run = peel(SHAPES[name], scale, path, freed(end, SHAPES[name], scale))
                rows.append([name, end, f"Ixos, scale {scale:g}", *cells(measured(run, scale, SHAPES[name]))])
    print()
    recipe.table(["shape", "shaft's end", "model", *COLUMNS], rows)


def draw_curves(curves):
    """Draws force over lift of the shapes, with the beam's."""
    picture, axes = recipe.figure(1, 5.6, 3.2)
    for color, (name, (lift, force)) in zip(recipe.style.COLORS, curves.items()):
        axes.plot(lift, force, color=color, label=name)
        lift, force = beam.peel(SHAPES[name])
        axes.plot(lift, NANONEWTONS * force, ":", color=color)
    axes.plot([], [], ":", color=recipe.style.INK, label="beam, full size")
    axes.axhline(8, color=recipe.style.FAINT, zorder=0)
    axes.set(xlabel="lift of the full pad [nm]", ylabel="pull-off force of the full pad [nN]", xlim=(0, None),
             ylim=(0, 22))
    axes.legend()
    recipe.save(picture, "spatula")


def draw_parameters(model, found):
    """Draws a tornado: what 20 per cent of each parameter do to both peaks, of the beam and of Ixos."""
    names = list(dict.fromkeys(name for name, _ in model if name != "none"))
    picture, panels = recipe.figure(2, 7.2, 3.8)
    for axes, peak in zip(panels, ("late", "first")):
        def change(values, name, factor, peak=peak):
            return 100 * (values[name, factor][peak] / values["none", 1.0][peak] - 1)

        order = sorted(names, key=lambda name: max(abs(change(model, name, factor)) for factor in (0.8, 1.2)))
        for factor, color in ((0.8, recipe.style.COLORS[0]), (1.2, recipe.style.COLORS[1])):
            axes.barh(order, [change(model, name, factor) for name in order], 0.7, color=color, alpha=0.6,
                      label=f"{100 * factor - 100:+.0f} %, beam")
            runs = [name for name in order if (name, factor) in found]
            axes.plot([change(found, name, factor) for name in runs], [order.index(name) for name in runs], "d",
                      markersize=4, color=color, markeredgecolor=recipe.style.INK, markeredgewidth=0.5,
                      label=f"{100 * factor - 100:+.0f} %, Ixos")
        axes.set(xlabel=f"change of the {peak} peak [%]")
        axes.grid(False, axis="y")
    panels[0].legend(loc="lower right", fontsize=7)
    path = recipe.ROOT / "docs/cookbook/spatula/parameters.png"
    picture.savefig(path, dpi=130)
    print(f"\nwrote {path.relative_to(recipe.ROOT)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("results/cookbook/spatula"),
                        help="folder of the results of all runs (default: %(default)s)")
    parser.add_argument("--only", choices=["shapes", "parameters", "ends"], help="one part")
    parser.add_argument("--scales", type=float, nargs="+", default=[0.25], choices=list(MESHES),
                        help="sizes of the pads that compare the shapes (default: 0.25)")
    parser.add_argument("--step", type=float, default=0.5, help="time step that compares the shapes (default: 0.5)")
    parser.add_argument("--finished", action="store_true", help="no new runs: only those that are finished")
    arguments = parser.parse_args()
    if arguments.only in (None, "shapes"):
        draw_curves(compare_shapes(arguments.results, arguments.scales, arguments.step, arguments.finished))
    if arguments.only in (None, "parameters"):
        draw_parameters(*compare_parameters(arguments.results, arguments.finished))
    if arguments.only in (None, "ends"):
        compare_ends(arguments.results, arguments.finished)


if __name__ == "__main__":
    main()
