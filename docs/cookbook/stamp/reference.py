#!/usr/bin/python3
"""Computes reference.csv without Ixos: a rigid chip below a viscoelastic half-plane that is lifted.

    docs/cookbook/stamp/reference.py > docs/cookbook/stamp/reference.csv

The gap at x_i below the half-plane is g_i = r_eq + U(t) + sum_j C_ij int J(t - t') dT_j(t'), with the lift U, the
displacement C_ij by unit pressures on the strips j and -j (Johnson 1985, section 2.7; docs/cookbook/cylinders) and the
creep compliance J of which 1/E*(p) is the transform. J has an instant part and retarded ones, which follow the
traction. Displacements of a half-plane refer to a depth D. It moves the lift, but hardly the largest force.

A crack runs in from both edges of the chip. If it meets one modulus E* only, the chip of the half width a is a flat
punch, which comes off at
    F = (2 pi E* W a)^(1/2)      (Johnson 1985, section 5.5),
the limits of slow and of fast lifts. The wall under the chip lets go at 2 a s, s its strength, for a rigid chip that is
lifted upright."""
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / folder) for folder in ("jkr", ".")]
from half_space import equilibrium  # noqa: E402
from recipe import EQUILIBRIUM_GAP, STRENGTH, WORK, law  # noqa: E402

HALF_WIDTH = 30.0  # a, of the chip
SHEAR, POISSON, BRANCH, TIME = 0.105, 0.4, 0.595, 10.0  # of the stamp in xml/stamp.xml
BULK = 2 * SHEAR * (1 + POISSON) / (3 * (1 - 2 * POISSON))
DEPTH = 380.0  # D
SPEEDS = 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 10.0
DEFAULT = 25.0  # Gamma W of the default law; work and strength are proportional to its inverse


def plane(shear):
    """Returns E/(1 - nu^2) for a shear modulus and the bulk modulus of the stamp."""
    return 4 * shear * (3 * BULK + shear) / (3 * BULK + 4 * shear)


def limit(shear):
    """Returns the force at which a stamp of one shear modulus comes off the chip."""
    return (2 * np.pi * plane(shear) * WORK * HALF_WIDTH) ** 0.5


def wall(gamma):
    """Returns the force at which the wall lets a rigid chip go, for the wall's Gamma W."""
    return 2 * HALF_WIDTH * STRENGTH * DEFAULT / gamma


def creep():
    """Returns 1/E*(p) as the instant compliance, retarded compliances, and their times.

    With mu(p) = mu + mu_b p tau/(1 + p tau), 1/E* = 1/(4 mu) + 3/(4 (3 K + mu)): two standard solids in series."""
    instant, retarded, times = 0.0, [], []
    for factor, shift in ((1 / 4, 0.0), (3 / 4, 3 * BULK)):
        slow, fast = shift + SHEAR, shift + SHEAR + BRANCH
        instant += factor / fast
        retarded.append(factor * (1 / slow - 1 / fast))
        times.append(TIME * fast / slow)
    return instant, np.array(retarded), np.array(times)


class Lift:
    """The half-plane while it is lifted off the chip."""

    def __init__(self, strips):
        edges = HALF_WIDTH * (1 - (1 - np.linspace(0, 1, strips + 1)) ** 1.5)
        self.middle, self.strips = (edges[1:] + edges[:-1]) / 2, 2 * np.diff(edges)

        def integral(end):  # of ln(|x - s|/D) over s, up to an end
            distance = end - self.middle[:, None]
            return distance * (np.log(np.abs(distance) / DEPTH) - 1)
        self.compliance = -2 / np.pi * (integral(edges[None, 1:]) - integral(edges[None, :-1])
                                        + integral(-edges[None, :-1]) - integral(-edges[None, 1:]))
        self.instant, self.retarded, self.times = creep()
        self.gap = np.full(strips, EQUILIBRIUM_GAP)
        self.memory = np.zeros((len(self.times), strips))

    def step(self, lift, dt):
        """Returns the force after a step; None if the stamp comes off at once."""
        share = dt / (self.times + dt)
        shape = EQUILIBRIUM_GAP + lift + self.compliance @ (self.retarded * (1 - share) @ self.memory)
        gap = equilibrium(self.gap, shape, self.compliance * (self.instant + self.retarded @ share))
        if gap is None:
            return None
        self.gap = gap
        traction = law(gap)[1]
        self.memory += share[:, None] * (traction - self.memory)
        return -self.strips @ traction


def force_off(speed, strips=150, step=0.02):
    """Returns the largest force of a lift at a speed."""
    model, lift, largest = Lift(strips), 0.0, 0.0
    while lift < 20:
        lift += step
        force = model.step(lift, step / speed)
        if force is None or force < 0.8 * largest:
            break
        largest = max(largest, force)
    return largest


def main():
    strips = int(sys.argv[1]) if len(sys.argv) > 1 else 150
    print("speed,force")
    for speed in SPEEDS:
        print(f"{speed:g},{force_off(speed, strips):.4f}", flush=True)


if __name__ == "__main__":
    main()
