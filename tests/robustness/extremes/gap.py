"""Gaps from 1e-3 to 1e3 r0: the forces of the law, and what a body does that is released there."""
import numpy as np

import maps
from runs import R0, SCHEMES, box, number, steps, table, wall

GAPS = [float(f"{10 ** k:.1e}") for k in np.arange(-3, 3.1, 0.5)]
C1, C2 = np.pi / (45 * 25 * 2.5 ** 9), np.pi / (3 * 25 * 2.5 ** 3)


def traction(r):
    return C1 / r ** 9 - C2 / r ** 3


def energy(r):
    return C1 / (8 * r ** 8) - C2 / (2 * r ** 2)


def block(gap, **law):
    """Sixteen elements, 4 by 4, before the wall."""
    return {**box((4, 4), (4, 4), (0, gap)), **wall(**law)}


def released(runner, step):
    """outcomes[scheme][gap] of bodies at rest."""
    return [[runner(f"gap/{step}/{scheme}/{gap}", {**block(gap * R0), **steps(scheme, step, 300)}) for gap in GAPS]
            for scheme in SCHEMES]


def forces(outcomes):
    """Rows: force and energy in the first row of the history, to the closed form."""
    result = []
    for gap, outcome in zip(GAPS, outcomes):
        run, r = outcome.run, gap * R0
        force, stored = run["contact_force_y"][0], run["contact_energy"][0]
        result.append([f"{gap:g}", number(traction(r)), number(abs(force / (4 * traction(r)) - 1)),
                       number(abs(stored / (4 * energy(r)) - 1))])
    return result


def study(runner, images):
    long, short = released(runner, 1e-3), released(runner, 1e-5)
    maps.picture([("Δt = 0.001 T₀", long, GAPS, ""), ("Δt = 0.00001 T₀", short, GAPS, "gap at the start / r₀")],
                 images / "extremes-gap")
    return [*table(["gap / r0", "traction [E0]", "error of the force", "error of the energy"], forces(short[6])), "",
            "dt = 0.001", "", *table(["scheme", *map(str, GAPS)], maps.rows(long, SCHEMES, GAPS)), "",
            *maps.messages(long), "", "dt = 0.00001", "",
            *table(["scheme", *map(str, GAPS)], maps.rows(short, SCHEMES, GAPS)), "", *maps.messages(short)]
