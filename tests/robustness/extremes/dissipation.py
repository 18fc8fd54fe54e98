"""Maxwell branches and friction: 10,000 steps with both, relaxation times from 1e-6 to 1e6 steps, friction from 0 to 10."""
import numpy as np

import maps
from bounces import ADHESION, BOTTOM, bounces, on_moving_wall, swing
from gap import block
from runs import R0, number, steps, table

STEP, STEPS = 0.02, 10000
RELAXATION = [float(f"1e{k}") for k in range(-6, 7)]
FRICTION = [0.0, 1e-9, 1e-5, 0.01, 0.1, 0.3, 1.0, 3.0, 10.0]
SCHEMES = ["Newmark", "Bathe Composite", "Average Vector Field"]
CLOSED = {"Time Integrator/Average Vector Field/Interaction Points": 0}


def branches(times, moduli):
    path = "Materials/Body/Maxwell Branches/"
    return {path + "Relaxation Times": list(times), path + "Moduli": list(moduli)}


def friction(coefficient, threshold="Lagged"):
    path = "Interactions/Wall/Friction/"
    return {path + "Type": "Extended Amontons", path + "Coefficient": coefficient, path + "Threshold": threshold}


def bouncing():
    """A viscoelastic block that is thrown at a wall, which swings by 0.1 L0 along itself and by 0.02 L0 across, and turns:
    it bounces, slides, sticks, and is shaken until the end."""
    return {**on_moving_wall(), **swing("Along", 0.1, 0.9), "Initial Conditions/Velocity": [0.2, -0.2],
            **branches([0.1, 2.0], [0.2, 0.1]), **friction(0.3), **steps("Average Vector Field", STEP, STEPS), **CLOSED}


def total_work(run):
    """The sum of the magnitudes of the work of all steps, and the kinetic energy at the start."""
    return float(np.abs(np.diff(run["external_work"])).sum() + run["kinetic_energy"][0])


def error(run):
    """The largest energy error over the total work and the work of adhesion of the body's surface."""
    return float(run.energy_error().max() / (total_work(run) + ADHESION * BOTTOM))


def share(run):
    """The dissipated energy of each source, by name."""
    return {name: float(run[name][-1]) for name in run.columns
            if name.startswith("dissipated_") and name != "dissipated_energy"}


def thrown(entries, scheme):
    """A body that is thrown at the wall with 1 L0/T0, and along it, from the gap r0; 1000 steps of 0.001 T0."""
    exact = CLOSED if scheme == "Average Vector Field" else {}
    return {**block(R0), "Initial Conditions/Velocity": [1.0, -1.0], **entries, **steps(scheme, 1e-3, 1000), **exact}


AXES = {
    "relaxation": ("relaxation time [Δt]", RELAXATION, lambda value: branches([value * 1e-3], [0.4])),
    "friction": ("coefficient of friction", FRICTION, friction),
    "current": ("coefficient of friction, current threshold", FRICTION, lambda value: friction(value, "Current")),
}


def study(runner, images):
    del images
    lines = []
    outcome = runner("dissipation/bounces", bouncing(), timeout=900)
    run = outcome.run
    lines += [f"{STEPS} steps of a block on a wall that swings and turns: {bounces(run)} bounces, total work {number(total_work(run))}, "
              f"error over it and the work of adhesion {number(error(run), 1)}", "",
              *table(["source", "dissipated [E0 L0^2]"], [[name, number(value, 3)] for name, value in share(run).items()]), ""]
    for name, (title, values, entries) in AXES.items():
        found = [[runner(f"dissipation/{name}/{scheme}/{value}", thrown(entries(value), scheme)) for value in values]
                 for scheme in SCHEMES]
        lines += [title, "", *table(["scheme", *(f"{value:g}" for value in values)], maps.rows(found, SCHEMES, values)),
                  "", *maps.messages(found), ""]
    return lines
