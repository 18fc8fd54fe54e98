#!/usr/bin/python3
"""Peels spatulae of several shapes, on pads of a quarter of the size, and compares them with the beam of reference.py:
three shapes, then the default shape with one parameter changed by 20 per cent. Finished runs are not repeated.

    docs/cookbook/spatula/study.py [--results FOLDER] [--only shapes|parameters]"""
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
MESHES = {0.25: (0.7, 12), 0.5: (1.0, 16), 1.0: (1.28, 20)}
SHAPES = {"stiff": beam.STIFF, "thin": beam.THIN, "narrow": {**beam.THIN, "Neck Width": 60.0}, "default": beam.DEFAULT}


def scaled(shape, scale):
    """Returns a pad of another size that bends alike: its bending stiffness over W times its squared length stays."""
    def factor(name):
        return 1 if name == "Inclination" else scale**(2 / 3) if "Thickness" in name else scale
    return {name: factor(name) * value for name, value in shape.items()}


def settings(shape, scale, step=0.5):
    """Returns the settings of a run until the pad is free. shape: of the full size; lengths are scaled here."""
    face, columns = MESHES[scale]
    small = scaled(shape, scale)
    along = small["Pad Length"] + small["Transition Length"] * math.log(GROWTH) / (GROWTH - 1) \
        + small["Shaft Length"] / GROWTH
    mesh = {**small, "Core Cells": columns, "Core Layers": 1, "Rings": 1, "Tip Rows": columns // 4, "Growth": GROWTH,
            "Stations": round(along / face)}
    return {**recipe.QUIET, **{"Mesh/Spatula/" + name: value for name, value in mesh.items()},
            "Output/Probes/P/Point": [small["Pad Length"], 0.0, recipe.EQUILIBRIUM_GAP],
            "Histories/Pull/Rate Ramp/Length": RAMP * scale, "Time Integrator/Type": "Average Vector Field",
            "Time Integrator/Stop/Free/Type": "Detached", recipe.STEPS + "Time Step": step,
            recipe.STEPS + "Final Time": 600.0 * scale}


def peel(shape, scale, folder, changes=None):
    """Runs a shape, unless the folder has the finished run."""
    summary = folder / "summary.json"
    if summary.exists() and json.loads(summary.read_text(encoding="utf-8"))["status"] == "completed":
        return recipe.results.Run(folder)
    return recipe.run("spatula", {**settings(shape, scale), **(changes or {})}, folder)


def curve(run, scale):
    """Returns lift [nm] and force [nN] of a run as those of the full pad. The forces are means over the steps."""
    lift, force = run.applied(run["time"]), run["reaction_shaft end_z"]
    return np.append(0, (lift[1:] + lift[:-1]) / 2) / scale, NANONEWTONS * force / scale


def measured(run, scale, shape):
    """Returns the measures of a run as those of the full pad: forces in nN, lifts in nm, work in E0 L0^3."""
    return beam.measures(*curve(run, scale), shape["Pad Length"]) | {
        "work": run["external_work"][-1] / scale**2, "balance": balance(run), "iterations":
        run["newton_iterations"].sum() / run["step"][-1]}


def predicted(shape, scale=1.0):
    """Returns the same of the beam."""
    lift, force = beam.peel(scaled(shape, scale), scale, scale)
    found = beam.measures(lift / scale, NANONEWTONS * force / scale, shape["Pad Length"])
    return found | {"work": found["work"] / NANONEWTONS}


def balance(run):
    """Returns the largest error of the energy balance over the work."""
    error = run["total_energy"] - run["external_work"] + run["dissipated_energy"]
    return abs(error - error[0]).max() / run["external_work"].max()


def varied():
    """Yields name, factor and shape: the default shape with one parameter 20 per cent smaller or larger.

    The outline has to fit: Pad Length stretches all of the outline, and a longer widening or end shortens the other."""
    for name in beam.DEFAULT:
        for factor in (0.8, 1.2):
            shape = {**beam.DEFAULT, name: factor * beam.DEFAULT[name]}
            room = shape["Pad Length"]
            if name == "Pad Length":
                shape |= {other: factor * beam.DEFAULT[other] for other in ("Widening Length", "Tip Length")}
            elif name == "Widening Length":
                shape["Tip Length"] = min(shape["Tip Length"], room - shape[name])
            elif name == "Tip Length":
                shape["Widening Length"] = min(shape["Widening Length"], room - shape[name])
            yield name, factor, shape
    for factor in (0.8, 1.2):
        yield "both thicknesses", factor, {**beam.DEFAULT, **{name: factor * beam.DEFAULT[name]
                                                              for name in ("Rear Thickness", "Tip Thickness")}}


def cells(found):
    """Returns the cells of a table: both peaks with their lifts, the least force between, lift of release, work."""
    first, late = found["first"], found["late"]
    return [f"{first[0]:.2f}", f"{first[1]:.0f}", f"{found['trough'][0]:.2f}", f"{late[0]:.2f}", f"{late[1]:.0f}",
            f"{found['free']:.0f}", f"{found['work']:.0f}"]


COLUMNS = ["first peak [nN]", "at [nm]", "least between [nN]", "late peak [nN]", "at [nm]", "free at [nm]",
           "work [E0 L0^3]"]


def compare_shapes(folder, scales):
    """Prints the table of shapes. Returns the curves at the smallest scale."""
    rows, curves = [], {}
    for name, shape in SHAPES.items():
        for scale in scales:
            run = peel(shape, scale, folder / f"{name}-{scale:g}")
            found = measured(run, scale, shape)
            rows.append([name, f"Ixos, scale {scale:g}", *cells(found), f"{100 * found['balance']:.2f} %",
                         f"{found['iterations']:.1f}"])
            rows.append([name, f"beam, scale {scale:g}", *cells(predicted(shape, scale)), "", ""])
        rows.append([name, "beam, scale 1", *cells(predicted(shape)), "", ""])
        curves[name] = curve(peel(shape, scales[0], folder / f"{name}-{scales[0]:g}"), scales[0])
    recipe.table(["shape", "", *COLUMNS, "error of the balance / work", "Newton/increment"], rows)
    return curves


def compare_parameters(folder, scale=0.25):
    """Prints the table of changed parameters. Returns their measures, of Ixos and of the beam."""
    base = measured(peel(beam.DEFAULT, scale, folder / f"default-{scale:g}"), scale, beam.DEFAULT)
    found, rows = {}, [["default", *cells(base), ""]]
    model = predicted(beam.DEFAULT)
    for name, factor, shape in varied():
        sign = "-" if factor < 1 else "+"
        run = peel(shape, scale, folder / f"{name.replace(' ', '-').lower()}{sign}20")
        found[name, factor] = measured(run, scale, shape), predicted(shape)
        rows.append([f"{name} {sign} 20 %", *cells(found[name, factor][0]),
                     f"{found[name, factor][1]['first'][0]:.2f}, {found[name, factor][1]['late'][0]:.2f}"])
    rows[0][-1] = f"{model['first'][0]:.2f}, {model['late'][0]:.2f}"
    print()
    recipe.table(["", *COLUMNS, "beam of full size: first, late [nN]"], rows)
    return base, model, found


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


def draw_parameters(base, model, found):
    """Draws a tornado: what 20 per cent of each parameter do to both peaks."""
    names = list(dict.fromkeys(name for name, _ in found))
    picture, panels = recipe.figure(2, 7.2, 3.8)
    for axes, peak in zip(panels, ("late", "first")):
        def change(name, factor, which, peak=peak):
            return 100 * (found[name, factor][which][peak][0] / (base, model)[which][peak][0] - 1)

        order = sorted(names, key=lambda name: max(abs(change(name, f, 0)) for f in (0.8, 1.2)))
        for y, name in enumerate(order):
            for factor, color in ((0.8, recipe.style.COLORS[0]), (1.2, recipe.style.COLORS[1])):
                axes.barh(y, change(name, factor, 0), 0.7, color=color, label=f"{100 * (factor - 1):+.0f} %" * (y == 0))
                axes.plot(change(name, factor, 1), y, "d", markersize=3.5, color=recipe.style.INK,
                          label="beam, full size" * (y == 0 and factor > 1))
        axes.set(yticks=range(len(order)), yticklabels=order, xlabel=f"change of the {peak} peak [%]")
        axes.grid(False, axis="y")
    panels[0].legend(loc="lower right")
    path = recipe.ROOT / "docs/cookbook/spatula/parameters.png"
    picture.savefig(path, dpi=130)
    print(f"wrote {path.relative_to(recipe.ROOT)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("results/cookbook/spatula"),
                        help="folder of the results of all runs (default: %(default)s)")
    parser.add_argument("--only", choices=["shapes", "parameters"], help="one of the two parts")
    parser.add_argument("--scales", type=float, nargs="+", default=[0.25], choices=list(MESHES),
                        help="sizes of the pads that compare the shapes (default: 0.25)")
    arguments = parser.parse_args()
    if arguments.only != "parameters":
        draw_curves(compare_shapes(arguments.results, arguments.scales))
    if arguments.only != "shapes":
        draw_parameters(*compare_parameters(arguments.results))


if __name__ == "__main__":
    main()
