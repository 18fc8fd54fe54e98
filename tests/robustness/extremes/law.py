"""Laws from Gamma L = 0.1 to 100 and Gamma W = 0.1 to 1e4, with fixed and with adaptive steps."""
import numpy as np

import maps
from runs import STEPS, box, number, steps, table, wall

LENGTHS = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0]
ENERGIES = [0.1, 1.0, 10.0, 100.0, 1e3, 1e4]

ADAPTIVE = {STEPS + "Type": "Adaptive", STEPS + "Adaptive/Maximum Gap Ratio": 1.1,
            STEPS + "Adaptive/Maximum Time Step": 1e-3, STEPS + "Final Time": 0.02}


def body(length, energy, gap):
    """Sixteen elements, 4 by 4, at `gap` times the equilibrium gap of the law."""
    return {**box((4, 4), (4, 4), (0, gap * 15 ** (-1 / 6) / length)), **wall(Gamma_L=length, Gamma_W=energy)}


def released(runner, name, extra):
    return [[runner(f"law/{name}/{length}/{energy}",
                    {**body(length, energy, 1.2), **steps("Average Vector Field", 1e-3, 200), **extra}, timeout=60)
             for length in LENGTHS] for energy in ENERGIES]


def at_peak(length, energy):
    """At 3^(1/6) equilibrium gaps, 5^(-1/6) r0, the attraction is largest."""
    return {**body(length, energy, 3 ** (1 / 6)), **steps("Central Difference", 1e-12, 1)}


def peak_error(outcome, energy):
    """Relative error of that traction, -(2 sqrt5/9) pi/Gamma W."""
    return abs(outcome.run["contact_force_y"][0] / (-4 * 2 * 5 ** 0.5 / 9 * np.pi / energy) - 1)


def peak_errors(runner):
    """The largest of all laws."""
    return max(peak_error(runner(f"law/peak/{length}/{energy}", at_peak(length, energy)), energy)
               for length in LENGTHS for energy in ENERGIES)


def study(runner, images):
    fixed, chosen = released(runner, "fixed", {}), released(runner, "adaptive", ADAPTIVE)
    names = [f"$γ_W$ = {energy:g}" for energy in ENERGIES]
    maps.picture([("Δt = 0.001 T₀", fixed, LENGTHS, "$γ_L$"),
                  ("gap ratio 1.1 a step, to 0.02 T₀", chosen, LENGTHS, "$γ_L$")], images / "extremes-law",
                 names, 2)
    plain = [f"{energy:g}" for energy in ENERGIES]
    head = ["Gamma W \\ Gamma L", *map(str, LENGTHS)]
    return ["dt = 0.001", "", *table(head, maps.rows(fixed, plain, LENGTHS)), "", *maps.messages(fixed), "",
            "A gap ratio of 1.1 a step, to 0.02 T0", "", *table(head, maps.rows(chosen, plain, LENGTHS)), "", *maps.messages(chosen), "",
            f"Largest relative error of the peak traction, all 42 laws: {number(peak_errors(runner))}"]
