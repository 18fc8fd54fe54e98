#!/usr/bin/python3
"""Computes reference.csv without Ixos: a rigid paraboloid before a viscoelastic half-space under the law of the wall.

    docs/cookbook/sphere-hysteresis/reference.py > docs/cookbook/sphere-hysteresis/reference.csv

The gap at the radius r_i is

    g_i = r_eq - delta + r_i^2/(2 R) + sum_j C_ij int J(t - t') dT_j(t'),

where C_ij is E* times the displacement at r_i by a unit pressure on ring j, and J(t) is the creep compliance of which
1/E*(p) is the transform (Johnson 1985, section 3.4 and chapter 6). J has an instant part and retarded ones. Each
follows the traction like a spring beside a dashpot: one number a ring. Backward Euler steps integrate it."""
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / folder) for folder in ("jkr", "restitution", ".")]
import adhesion  # noqa: E402
from half_space import RADIUS, equilibrium  # noqa: E402
from recipe import WORK, law  # noqa: E402
from viscoelastic_impact import plane_modulus  # noqa: E402

MODULUS, POISSON, BRANCH, TIME = 0.667579, 0.3, 1.0, 1.0  # of xml/sphere-hysteresis.xml
DEPTH = 1.5  # approach of the relaxed contact
SPEEDS = 0.001, 0.01, 0.1, 1.0, 10.0, 100.0
COLUMNS = "speed", "pull_off", "approach"


def creep():
    """Returns 1/E*(p) as the instant compliance, retarded compliances, and their times."""
    long, parts, times = plane_modulus(MODULUS, POISSON, BRANCH, TIME)
    numerator, denominator = np.array([long]), np.array([1.0])  # of E*(p), by falling powers
    for part, time in zip(parts, times):
        factor = np.array([time, 1.0])
        numerator = np.polyadd(np.polymul(numerator, factor), np.polymul(denominator, [part * time, 0.0]))
        denominator = np.polymul(denominator, factor)
    roots = np.roots(numerator)
    slope = np.polyder(numerator)
    retarded = [np.polyval(denominator, p) / (np.polyval(slope, p) * -p) for p in roots]
    return 1 / (long + parts.sum()), np.array(retarded), -1 / roots


class Pull(adhesion.HalfSpace):
    """The half-space while the sphere is pulled off, from the relaxed contact on."""

    def __init__(self, width):
        self.long = plane_modulus(MODULUS, POISSON, BRANCH, TIME)[0]
        super().__init__(self.long, width)
        self.instant, self.retarded, self.times = creep()
        self.gap = self.in_contact()
        for approach in np.linspace(0, DEPTH, 61):
            self.gap = equilibrium(self.gap, self.shape - approach, self.compliance / self.long)
        # Retarded tractions follow those of the rings; after the wait they are the same.
        self.memory = np.tile(law(self.gap)[1], (len(self.times), 1))

    def step(self, approach, dt):
        """Returns the force after a step; None where the sphere jumps off."""
        share = dt / (self.times + dt)
        shape = self.shape - approach + self.compliance @ (self.retarded * (1 - share) @ self.memory)
        gap = equilibrium(self.gap, shape, self.compliance * (self.instant + self.retarded @ share))
        if gap is None:
            return None
        self.gap = gap
        traction = law(gap)[1]
        self.memory += share[:, None] * (traction - self.memory)
        return self.area @ traction


def pull_off(width, speed, step=0.02):
    """Returns the pull-off force over pi R W, and the approach there."""
    model = Pull(width)
    approach, forces = DEPTH, []
    while not forces or forces[-1] < max(0.5 * min(forces), -0.5) or min(forces) > -0.5:
        approach -= step
        force = model.step(approach, step / speed)
        if force is None:
            break
        forces.append(force / (np.pi * RADIUS * WORK))
    i = int(np.argmin(forces))
    return -forces[i], DEPTH - (i + 1) * step


def main():
    width = float(sys.argv[1]) if len(sys.argv) > 1 else 0.5
    print(",".join(COLUMNS))
    for speed in SPEEDS:
        force, approach = pull_off(width, speed)
        print(f"{speed:g},{force:.4f},{approach:.2f}", flush=True)


if __name__ == "__main__":
    main()
