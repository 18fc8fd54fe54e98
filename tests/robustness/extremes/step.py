"""Time steps from 1e-9 to 1e3 T0."""
import maps
from gap import block, traction
from runs import EQUILIBRIUM, SCHEMES, STEPS as CONTROL, number, steps, table

STEPS = [float(f"1e{k}") for k in range(-9, 4)]
FINAL = CONTROL + "Final Time"
START = 1.2 * EQUILIBRIUM


def impulse_errors(outcomes):
    """Of steps so short that nothing moves: momentum over force times time, less 1."""
    result = []
    for outcome in outcomes:
        run = outcome.run
        time, force = run["time"][-1], 4 * traction(START)
        result.append(run["linear_momentum_y"][-1] / (force * time) - 1)
    return result


def thrown(scheme, step):
    """Along and at the wall. Central Difference takes its own stable steps, 3e-4 T0, where they are shorter: to 2 T0."""
    entries = {**block(START), **steps(scheme, step, 200), "Initial Conditions/Velocity": [1.0, -1.0]}
    if scheme == "Central Difference" and step > 0.01:
        entries.update({FINAL: 2.0, "Output/History Interval": 10})
    return entries


def study(runner, images):
    outcomes = [[runner(f"step/{scheme}/{step}", thrown(scheme, step)) for step in STEPS] for scheme in SCHEMES]
    short = [[runner(f"step/rest/{scheme}/{step}", {**block(START), **steps(scheme, step, 200)}) for step in STEPS[:4]]
             for scheme in SCHEMES]
    maps.picture([("thrown along and at the wall from 1.2 times the equilibrium gap", outcomes, STEPS, "time step [T₀]")],
                 images / "extremes-step")
    impulses = [[scheme, *(number(abs(error)) for error in impulse_errors(row))] for scheme, row in zip(SCHEMES, short)]
    return [*table(["scheme", *map(str, STEPS)], maps.rows(outcomes, SCHEMES, STEPS)), "", *maps.messages(outcomes), "",
            "From rest, momentum after 200 steps over force times time, less 1", "",
            *table(["scheme", *map(str, STEPS[:4])], impulses)]
