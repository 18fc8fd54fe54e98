#!/usr/bin/python3
"""Computes reference.csv without Ixos: the energy of the law between two rigid disks, by quadrature.

    docs/cookbook/two-balls/reference.py > docs/cookbook/two-balls/reference.csv

A point at the angle t of a disk of radius R has the distance |p - c| - R from the other disk, whose centre c is 2 R + D
away. The energy is the integral of the law over the arc, per depth. Without elasticity two disks that start with the
speed v each at the gap D meet with the kinetic energy m v^2 more than they need to part, and rebound with it."""
import pathlib
import sys

import numpy as np
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from recipe import law  # noqa: E402

RADIUS, DENSITY = 5.0, 5e-7  # of xml/two-balls.xml
MASS = np.pi * RADIUS ** 2 * DENSITY  # of a ball, per depth
START = 1.0  # gap of the balls at the beginning, along x


def energy(gap):
    """Returns the energy of the law between rigid disks at a gap."""
    def density(angle):
        point = np.array([RADIUS * np.cos(angle), RADIUS * np.sin(angle)])
        return law(np.hypot(2 * RADIUS + gap - point[0], point[1]) - RADIUS)[0]
    return 2 * RADIUS * quad(density, 0, np.pi, epsabs=1e-12, limit=200)[0]


def main():
    deepest = minimize_scalar(energy, bounds=(0.2, 0.4), method="bounded")
    print("quantity,value")
    print(f"energy at the start,{energy(START):.6f}")
    print(f"least energy,{deepest.fun:.6f}")
    print(f"gap there,{deepest.x:.4f}")
    print(f"speed of escape,{(-deepest.fun / MASS) ** 0.5:.3f}")


if __name__ == "__main__":
    main()
