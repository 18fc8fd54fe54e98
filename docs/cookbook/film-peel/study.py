#!/usr/bin/python3
"""Runs xml/film-peel.xml at several angles and compares the steady force with Kendall's and with the sliding formula;
then with friction, and compares with Kendall's formula for the work of adhesion and of friction.

    docs/cookbook/film-peel/study.py [--results FOLDER]"""
import math
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as formulas  # noqa: E402
from exodus import Fields  # noqa: E402 (of drivers/plot, which recipe makes known)

BONDED = 40.0, 60.0  # the force is steady, on average, while the bonded length is in this interval [nm]
FRICTION = "Interactions/Wall/Friction/"
ELASTIC_SLIP = 0.002  # [nm]
FRICTIONS = (30, 0.003), (30, 0.005), (30, 0.01), (60, 0.002)  # angle, threshold


def film_length(angle):
    """Returns a length of film that leaves room for a steady state: a weak force bends the arm over a longer part."""
    return 240 if angle > 150 else 160 if angle > 45 else 120


def folded(length):
    """Returns what a pull along the film needs besides: 40 nm of film that does not adhere, and a load that lifts them
    at the beginning."""
    return {"Mesh/Sets/bonded/Kind": "Sides", "Mesh/Sets/bonded/From": "bottom",
            "Mesh/Sets/bonded/Lower": [-10.0, 40.0 - length], "Mesh/Sets/bonded/Upper": [10.0, 1.0],
            "Interactions/Wall/Side Set": "bonded",
            "Histories/Lift/Type": "Expression", "Histories/Lift/Expression/Value": "t < 60 ? sin(_pi*t/60)^2 : 0",
            "Boundary Conditions/Lift/Type": "Traction", "Boundary Conditions/Lift/Side Set": "right",
            "Boundary Conditions/Lift/Vector": [0.003, 0.0], "Boundary Conditions/Lift/History": "Lift"}


def settings(angle, step=0.25, spacing=0.5):
    """Returns the settings of a run until 35 nm of film are still bonded."""
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    length, bonded, force = film_length(angle), 0.9 * BONDED[0], formulas.sliding(angle)
    end = (length - bonded) * (1 + force / formulas.STIFFNESS) \
        + bonded * (1 + force * cosine / formulas.STIFFNESS) * cosine - length * cosine
    step *= 2 if angle >= 90 else 1
    return {**recipe.QUIET, **(folded(length) if angle == 180 else {}),
            "Mesh/Box/Lengths": [length, 3], "Mesh/Box/Divisions": [round(length / spacing), 4],
            "Mesh/Map/X": f"{sine!r}*x - {cosine!r}*y", "Mesh/Map/Y": f"{cosine!r}*x + {sine!r}*y",
            "Interactions/Wall/Normal": [-cosine, sine], recipe.STEPS + "Final Time": step * math.ceil(end / step),
            recipe.STEPS + "Time Step": step}


def steady_force(run):
    """Returns mean, least and largest force of the steady part."""
    bonded = run["contact_measure"]
    force = run["reaction_right_y"][(bonded > BONDED[0]) & (bonded < BONDED[1])]
    if len(force) < 3:
        raise RuntimeError(f"{run.folder}: no steady part")
    return force.mean(), force.min(), force.max()


def with_friction(angle, stress):
    """Returns the settings of a run with friction, in short steps: a step's first gaps set where it acts."""
    return {**settings(angle, 0.1 if angle < 45 else 0.25), FRICTION + "Type": "Constant Stress",
            FRICTION + "Stress": stress, FRICTION + "Stiffness": stress / ELASTIC_SLIP,
            "Output/Fields": "{slip_Wall}", "Output/Fields Time Interval": 2}


def dissipated(run):
    """Returns the energy that friction dissipates per length of the front's way."""
    bonded = run["contact_measure"]
    steady = (bonded > BONDED[0]) & (bonded < BONDED[1])
    return -np.polyfit(bonded[steady], run["dissipated_friction_of_Wall"][steady], 1)[0]


def slip_zone(run, angle):
    """Returns the length of bonded film that has slipped, in the middle of the steady part."""
    fields = Fields(run.folder)
    bonded = np.interp(fields.times, run["time"], run["contact_measure"])
    frame = int(np.argmin(abs(bonded - np.mean(BONDED))))
    along = fields.coordinates @ [math.sin(math.radians(angle)), math.cos(math.radians(angle))]
    return bonded[frame] - along[fields.nodal("slip_Wall", frame) > 1e-6].min()


def compare_friction(folder):
    """Runs the frictions and prints their table. Returns angle, threshold and run of each."""
    rows, runs = [], []
    for angle, stress in FRICTIONS:
        run = recipe.run("film-peel", with_friction(angle, stress), folder / f"{angle:g}-{stress:g}")
        (force, _, _), lost = steady_force(run), dissipated(run)
        zone = formulas.slip_zone(angle, force, stress, stress / ELASTIC_SLIP)
        expected = formulas.kendall(angle, formulas.WORK + lost)
        rows.append([f"{angle:g}", f"{stress:g}", f"{zone:.1f}", f"{slip_zone(run, angle):.1f}", f"{lost:.5f}",
                     f"{formulas.kendall(angle):.5f}", f"{formulas.sliding(angle):.5f}", f"{expected:.5f}",
                     f"{force:.5f}", recipe.deviation(force, expected)])
        runs.append((angle, stress, run))
    print()
    recipe.table(["angle [degrees]", "tau", "slip zone, formula [nm]", "Ixos [nm]", "D", "Kendall with W", "sliding",
                  "Kendall with W + D", "Ixos", "difference"], rows)
    return runs


def draw(runs, forces, frictions):
    """Draws the force over the displacement, and the steady force over the angle."""
    picture, (left, right) = recipe.figure(2)
    for color, (angle, run) in zip(recipe.style.COLORS, runs.items()):
        left.plot(run["time"][1:], run["reaction_right_y"][1:], color=color, label=f"{angle:g}°")
    left.set(xlabel="displacement of the pulled end [nm]", ylabel="force per width [2 N/m]", yscale="log", xlim=(0, 60))
    left.legend(ncols=2)
    angles = np.linspace(15, 185, 100)
    right.plot(angles, [formulas.sliding(a) for a in angles], color=recipe.style.INK, label="far end held, sliding")
    right.plot(angles, [formulas.kendall(a) for a in angles], ":", color=recipe.style.INK, label="Kendall, no sliding")
    right.plot(list(runs), forces, "o", markersize=4, color=recipe.style.COLORS[0], label="Ixos")
    right.plot([angle for angle, _, _ in frictions], [steady_force(run)[0] for _, _, run in frictions], "s",
               markersize=4, fillstyle="none", color=recipe.style.COLORS[1], label="Ixos, friction")
    right.set(xlabel="angle [degrees]", ylabel="steady force per width [2 N/m]", yscale="log")
    right.legend()
    recipe.save(picture, "film-peel")


def main():
    folder = recipe.arguments(__doc__).results
    rows, runs, forces = [], {}, []
    for row in recipe.reference("film-peel"):
        angle = row["angle"]
        runs[angle] = recipe.run("film-peel", settings(angle), folder / f"{angle:g}")
        force, least, largest = steady_force(runs[angle])
        forces.append(force)
        rows.append([f"{angle:g}", f"{row['kendall']:.5f}", f"{row['sliding']:.5f}", f"{row['finite_strain']:.5f}",
                     f"{force:.5f}", recipe.deviation(force, row["sliding"]),
                     recipe.deviation(force, row["finite_strain"]), f"{100 * (largest - least) / force:.2f} %"])
    recipe.table(["angle [degrees]", "Kendall", "sliding", "sliding, finite strain", "Ixos", "to sliding",
                  "to finite strain", "range of the steady force"], rows)
    draw(runs, forces, compare_friction(folder))


if __name__ == "__main__":
    main()
