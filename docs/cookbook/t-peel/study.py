#!/usr/bin/python3
"""Runs xml/t-peel.xml as a double cantilever beam and as a T-peel, with matched and unmatched meshes, and compares the
forces with beams on the law and with closed forms. Prints the tables of t-peel.md and draws t-peel.png.

    docs/cookbook/t-peel/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as formulas  # noqa: E402
from exodus import Fields  # noqa: E402 (of drivers/plot, which recipe makes known)

STEADY = 60.0  # opening from which on the force of the T-peel is steady [nm]
VARIANTS = ((120, 120, True), (120, 120, False), (120, 84, True), (120, 84, False), (120, 40, False), (60, 60, True))


def meshes(upper, lower, length=formulas.LENGTH):
    """Returns the settings of numbers of cells along the strips, and of another length."""
    strips = {"upper": (upper, "Upper"), "lower": (lower, "Lower")}
    return {"Output/Probes/inner/Point": [length, 0.127354643894634],
            "Output/Probes/outer/Point": [length, 1.127354643894634],
            **{f"Mesh/Parts/{name}/Box/Divisions": [cells, 2] for name, (cells, _) in strips.items()},
            **{f"Mesh/Parts/{name}/Box/Lengths": [length, formulas.THICKNESS] for name in strips}}


def steps(opening, step):
    """Returns the settings of the last opening and of the steps."""
    return {recipe.STEPS + "Final Time": opening, recipe.STEPS + "Time Step": step}


def factors(both, upper="1"):
    """Returns the settings of the two lists of the pair: half of the law each, or all of it on the upper strip."""
    return {"Interactions/Upper/Factor": "0.5" if both else upper, "Interactions/Lower/Factor": "0.5" if both else "0"}


def beams():
    """Returns the settings of the double cantilever beam: stiff strips with a crack."""
    bonded = f"x < {formulas.LENGTH - formulas.CRACK:g} ? 0.5 : 0"
    return {**recipe.QUIET, **meshes(60, 60), "Materials/Upper/Young's Modulus": formulas.STIFF,
            "Materials/Lower/Young's Modulus": formulas.STIFF, "Interactions/Upper/Factor": bonded,
            "Interactions/Lower/Factor": bonded}


def angle(run):
    """Returns the angle by which the end of the upper strip has turned."""
    return np.arctan2(run["inner_ux"] - run["outer_ux"], formulas.THICKNESS + run["outer_uy"] - run["inner_uy"])


def forces(run):
    """Returns the forces that open the upper and the lower strip."""
    return run["reaction_upper_end_y"], -run["reaction_lower_end_y"]


def at(run, opening):
    """Returns the force on the upper strip and the angle of its end, at an opening."""
    return np.interp(opening, run["time"], forces(run)[0]), np.interp(opening, run["time"], angle(run))


def balance(force, turned, young):
    """Returns what the ends supply per length of the front's way, over W."""
    shear = 5 / 6 * young / (2 * (1 + formulas.POISSON)) * formulas.THICKNESS
    axial = formulas.plane(young) * formulas.THICKNESS
    along, across = force * np.sin(turned), force * np.cos(turned)
    return (2 * along + along ** 2 / axial + across ** 2 / shear) / formulas.WORK


def known(young):
    """Returns the rows of reference.csv of a modulus."""
    return [row for row in recipe.reference("t-peel") if row["modulus"] == young]


def compare(run, young, closed):
    """Prints the table of a run, with a closed form of the force at an opening."""
    rows = []
    for row in known(young):
        force, turned = at(run, row["opening"])
        rows.append([f"{row['opening']:g}", f"{closed(row['opening']):.6f}", f"{row['force']:.6f}", f"{force:.6f}",
                     recipe.deviation(force, row["force"]), f"{np.degrees(row['angle']):.2f}",
                     f"{np.degrees(turned):.2f}", f"{balance(force, turned, young):.4f}"])
    recipe.table(["opening [nm]", "closed form", "beam on the law", "Ixos", "difference", "angle, beam [degrees]",
                  "angle, Ixos", "supplied by the ends / W"], rows)


def cantilever(opening):
    """Returns Kanninen's force: that of the crack at rest, or of the front that moves, whichever is less."""
    at_rest = opening / formulas.compliance(formulas.STIFF, formulas.CRACK)
    return min(at_rest, formulas.double_cantilever(formulas.STIFF, opening))


def variants(folder):
    """Runs the T-peel with several meshes and prints their table. Returns the run of the scene."""
    rows, runs, expected = [], [], formulas.t_peel(formulas.SOFT)
    for upper, lower, both in VARIANTS:
        run = recipe.run("t-peel", {**recipe.QUIET, **meshes(upper, lower), **factors(both), **steps(72.0, 0.75)},
                         folder / f"{upper}-{lower}-{'both' if both else 'upper'}")
        steady = run["time"] >= STEADY
        one, other = (force[steady] for force in forces(run))
        middle = (one + other) / 2
        rows.append([f"{upper}, {lower}", "both" if both else "upper", f"{one.mean():.6f}", f"{other.mean():.6f}",
                     recipe.deviation(middle.mean(), expected), f"{100 * np.ptp(middle) / expected:.2f} %"])
        runs.append(run)
    print()
    recipe.table(["cells of upper and lower strip", "secondary", "force, upper", "force, lower",
                  "mean, to Kendall", "range"], rows)
    return runs[0]


def outline(axes, folder, frame):
    """Draws the strips at a frame of the scene's run."""
    fields = Fields(folder)
    places = fields.coordinates + fields.displacement(frame)
    for color, sign in zip(recipe.style.COLORS, (1, -1)):
        for edge in (recipe.EQUILIBRIUM_GAP / 2, recipe.EQUILIBRIUM_GAP / 2 + formulas.THICKNESS):
            side = np.nonzero(np.isclose(fields.coordinates[:, 1], sign * edge, atol=1e-6))[0]
            side = side[np.argsort(fields.coordinates[side, 0])]
            axes.plot(*places[side].T, color=color, linewidth=0.8)


def draw(beam, peel, scene):
    """Draws the forces of the double cantilever beam and of the T-peel over the opening, and the strips."""
    picture, (left, middle, right) = recipe.figure(3, 9.0, 3.0)
    ink, color = recipe.style.INK, recipe.style.COLORS[0]
    left.plot(beam["time"], forces(beam)[0], color=color, label="Ixos")
    opening = np.linspace(0.1, 16, 300)
    left.plot(opening, [cantilever(value) for value in opening], ":", color=ink, label="Kanninen")
    middle.plot(peel["time"][1:], forces(peel)[0][1:], color=color, label="Ixos")
    middle.axhline(formulas.t_peel(formulas.SOFT), color=ink, linestyle=":", label="Kendall")
    for axes, young in ((left, formulas.STIFF), (middle, formulas.SOFT)):
        axes.plot([row["opening"] for row in known(young)], [row["force"] for row in known(young)], "o", markersize=4,
                  fillstyle="none", color=ink, label="beam on the law")
        axes.set(xlabel="opening of the ends [nm]", ylabel="force per width [2 N/m]")
        axes.legend()
    left.set(title="double cantilever beam", ylim=(0, 0.05))
    middle.set(title="T-peel", ylim=(0, 0.03))
    outline(right, scene.folder, 8)
    right.set(aspect="equal", xlabel="x [nm]", ylabel="y [nm]", title="strips at an opening of 48 nm")
    recipe.save(picture, "t-peel")


def main():
    folder = recipe.arguments(__doc__).results
    beam = recipe.run("t-peel", {**beams(), **steps(16.0, 0.1)}, folder / "beam")
    compare(beam, formulas.STIFF, cantilever)
    fine = recipe.run("t-peel", {**beams(), **meshes(120, 120), **steps(2.0, 0.1)}, folder / "fine")
    row = next(row for row in known(formulas.STIFF) if row["opening"] == 2)
    print(f"\ncells of 0.5 nm, opening 2 nm: {recipe.deviation(at(fine, 2)[0], row['force'])}")
    print()
    scene = recipe.run("t-peel", {"Output/Checkpoint/Keep": 0}, folder / "scene")
    compare(scene, formulas.SOFT, lambda opening: formulas.t_peel(formulas.SOFT))
    draw(beam, variants(folder), scene)


if __name__ == "__main__":
    main()
