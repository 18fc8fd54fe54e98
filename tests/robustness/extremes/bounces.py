"""10,000 steps of bodies that bounce on a wall that moves and turns, in a spherical cavity, and on waves: the balance."""
import numpy as np

from obstacles import before
from runs import EQUILIBRIUM, box, number, steps, table

STEPS, STEP = 10000, 0.02
ADHESION = 0.01549567  # of the default law
BOTTOM = 2.0           # length of the body's surface
POINTS = [2, 4, 8, 12, 16, 24, 32, 48, 64]
FALL = {"Boundary Conditions/Weight/Type": "Gravity", "Boundary Conditions/Weight/Vector": [0.0, -0.02]}


def body(height, lower_x=0.0):
    """A block of 2 by 1 and eight elements."""
    return {**box((2, 1), (4, 2), (lower_x, height)), "Materials/Body/Poisson's Ratio": 0.3, "Materials/Body/Density": 1.0,
            "Nonlinear Solver/Tolerance": 1e-13, "Output/Interaction Columns": "On"}


def swing(name, amplitude, rate):
    """A history amplitude sin(rate t)."""
    path = f"Histories/{name}/"
    return {path + "Type": "Expression", path + "Expression/Value": f"{amplitude}*sin({rate}*t)",
            path + "Expression/Velocity": f"{amplitude * rate}*cos({rate}*t)",
            path + "Expression/Acceleration": f"{-amplitude * rate ** 2}*sin({rate}*t)"}


def on_moving_wall():
    """A body that falls on a flat wall, which swings by 0.05 L0 along itself, by 0.02 L0 across, and turns by 0.03."""
    wall = {"Interactions/Wall/Side Set": "bottom", "Interactions/Wall/Motion/Translation": ["Along", "Up"],
            "Interactions/Wall/Motion/Rotation": "Turn", "Interactions/Wall/Motion/Point": [1.0, 0.0]}
    return {**body(1.0), **FALL, **wall, **swing("Along", 0.05, 0.9), **swing("Up", 0.02, 1.5), **swing("Turn", 0.03, 0.7)}


def in_cavity():
    """A body in a spherical cavity about the origin, in which it flies from side to side and turns."""
    return {**body(-0.5, -1.0), **before("Sphere", Radius=2.0, Cavity=True), "Interactions/Wall/Side Set": "surface",
            "Initial Conditions/Velocity": [0.1, -0.2], "Initial Conditions/Velocity Gradient": [0.0, -0.05, 0.05, 0.0]}


def on_waves():
    """A body that falls on waves at rest, whose slope is 0.16, and slides over them."""
    waves = before("Sine Wall", Amplitude=0.1, Period=4.0)
    return {**body(2.0), **FALL, **waves, "Interactions/Wall/Cutoff": 2.0, "Initial Conditions/Velocity": [0.1, 0.0]}


SCENES = {"wall that moves and turns": on_moving_wall, "spherical cavity": in_cavity, "sine wall": on_waves}


def with_points(scheme, points=None):
    """The entries of all steps."""
    entries = steps(scheme, STEP, STEPS)
    return entries if points is None else {**entries, f"Time Integrator/{scheme}/Interaction Points": points}


def bounces(run):
    """How often the least gap passes twice the equilibrium gap on its way to the wall."""
    near = run["min_gap"] < 2 * EQUILIBRIUM
    return int(np.count_nonzero(near[1:] & ~near[:-1]))


def error(run):
    """The largest energy error over the work of adhesion of the body's surface."""
    return float(run.energy_error().max() / (ADHESION * BOTTOM))


def moment_error(run):
    """The largest change of the angular momentum over its largest magnitude."""
    moment = run["angular_momentum_z"]
    return float(np.abs(moment - moment[0]).max() / np.abs(moment).max())


def study(runner, images):
    del images
    runs = [("Average Vector Field, closed form", "Average Vector Field", 0), ("Energy-Momentum", "Energy-Momentum", None),
            *((f"Average Vector Field, {count} points", "Average Vector Field", count) for count in POINTS)]
    rows, moments = [], []
    for title, scheme, points in runs:
        row = [title]
        for place, scene in SCENES.items():
            outcome = runner(f"bounces/{place}/{title}", {**scene(), **with_points(scheme, points)})
            if outcome.kind != "completed":
                row += [outcome.kind, "-"]
                continue
            row += [number(error(outcome.run), 1), bounces(outcome.run)]
            if place == "spherical cavity" and (points or 0) in (0, POINTS[-1]):
                moments.append(f"{title} {number(moment_error(outcome.run), 1)}")
        rows.append(row)
    head = ["scheme", *(word for place in SCENES for word in (place, "bounces"))]
    return [f"Largest energy error of {STEPS} steps over the work of adhesion of the body's surface:", "",
            *table(head, rows), "", f"Moment of momentum about the centre of the cavity, largest change over its largest "
            f"magnitude: {'; '.join(moments)}."]
