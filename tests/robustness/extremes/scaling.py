"""Units over twelve decades: with everything scaled together the same numbers must come, to the last bit."""
import numpy as np

from runs import SCHEMES, number, steps, table

POWERS = {"stresses": (0, 20, 0), "lengths": (20, 0, 0), "times": (0, 0, 20), "all": (-20, 20, -20)}


def ball(length, stress, time, scheme, extra):
    """A damped ball thrown at the wall in units of these sizes."""
    entries = {
        "Mesh/Type": "Disk", "Mesh/Disk/Diameter": 10.0 * length, "Mesh/Disk/Center": [0.0, 5.4 * length],
        "Materials/Ball/Young's Modulus": stress, "Materials/Ball/Density": 2.0 ** -21 * stress * (time / length) ** 2,
        "Materials/Ball/Mass Damping": 0.5 / time, "Materials/Ball/Stiffness Damping": 1e-6 * time,
        "Interactions/Wall/Side Set": "surface", "Interactions/Wall/Gamma L": 2.5 / length,
        "Interactions/Wall/Gamma W": 25.0 / stress,
        "Initial Conditions/Velocity": [0.5 * length / time, -4.0 * length / time],
        "Boundary Conditions/Weight/Type": "Body Force", "Boundary Conditions/Weight/Vector": [0.0, -1e-3 * stress / length],
        **steps(scheme, 2.0 ** -10 * time, 200), **extra}
    if scheme == "Energy-Momentum" or scheme == "Static":
        del entries["Materials/Ball/Stiffness Damping"]
    return entries


def cases():
    for scheme in SCHEMES:
        yield scheme, scheme, {}
    avf = "Average Vector Field"
    for formulation in ("Mean Dilatation", "Enhanced"):
        yield formulation, avf, {"Materials/Ball/Element Formulation": formulation, "Materials/Ball/Poisson's Ratio": 0.49}
    yield "Q1C4", avf, {"Interactions/Wall/Contact Element": "Q1C4"}
    for kind in ("MueLu", "Ifpack2"):
        yield f"CG, {kind}", avf, {"Linear Solver/Linear Solver Type": "Belos", "Linear Solver/Preconditioner Type": kind}


def difference(outcome, reference, scales):
    """The largest difference of the scaled columns, relative to the largest value; 0 is every bit."""
    if outcome.kind != "completed":
        return outcome.kind
    worst = 0.0
    for name, scale in scales.items():
        one, other = reference.run[name], outcome.run[name] / scale
        if len(one) != len(other):
            return "other steps"
        worst = max(worst, np.abs(other - one).max() / max(np.abs(one).max(), 1e-300))
    return "0" if worst == 0 else number(worst, 1)


def study(runner, images):
    del images
    rows = []
    for name, scheme, extra in cases():
        reference = runner(f"scaling/{name}/1", ball(1.0, 1.0, 1.0, scheme, extra))
        row = [name]
        for powers in POWERS.values():
            for sign in (-1, 1):
                length, stress, time = (2.0 ** (sign * power) for power in powers)
                outcome = runner(f"scaling/{name}/{length}-{stress}-{time}", ball(length, stress, time, scheme, extra))
                energy = stress * length ** 2
                row.append(difference(outcome, reference, {
                    "total_energy": energy, "dissipated_energy": energy, "external_work": energy, "time": time,
                    "min_gap": length, "contact_force_y": stress * length, "newton_iterations": 1}))
        rows.append(row)
    return table(["", *(f"{name} times 2^{sign * 20}" for name in POWERS for sign in (-1, 1))], rows)
