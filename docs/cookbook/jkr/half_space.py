#!/usr/bin/python3
"""Computes reference.csv without Ixos: a rigid paraboloid before an elastic half-space under the law of the wall.

    docs/cookbook/jkr/half_space.py > docs/cookbook/jkr/reference.csv

The gap at the radius r_i is g_i = r_eq - delta + r_i^2/(2 R) + sum_j C_ij T(g_j), where C_ij is the displacement of the
half-space at r_i by a unit pressure on ring j (Johnson 1985, section 3.4)."""
import pathlib
import sys

import numpy as np
from scipy.special import ellipe, ellipkm1

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from recipe import EQUILIBRIUM_GAP, WORK, law, vertex  # noqa: E402

RADIUS = 1000.0
PEAK_GAP = 3 ** (1 / 6) * EQUILIBRIUM_GAP  # of largest attraction: contact_measure counts smaller gaps
COLUMNS = "tabor", "modulus", "pull_off", "approach", "radius"


def modulus(tabor):
    """Returns E* for a Tabor number."""
    return (RADIUS * WORK ** 2 / (tabor * EQUILIBRIUM_GAP) ** 3) ** 0.5


def disc(r, a):
    """Returns E* times the displacement at the radii r by a unit pressure on a disc of radius a."""
    ratio = (np.minimum(r, a) / np.maximum(r, a)) ** 2
    inside, outside = a * ellipe(ratio), r * (ellipe(ratio) - (1 - ratio) * ellipkm1(1 - ratio))
    return 4 / np.pi * np.where(r <= a, inside, outside)


def ring_edges(width, fine, last):
    """Returns the edges of rings: of one width up to a radius, then growing by a tenth each."""
    edges = list(np.arange(0, fine + width / 2, width))
    while edges[-1] < last:
        edges.append(edges[-1] + 1.1 * (edges[-1] - edges[-2]))
    return np.array(edges)


def contact_radius(middle, gap):
    """Returns the radius at which the gap passes that of largest attraction; 0 without contact."""
    inside = np.nonzero(gap < PEAK_GAP)[0]
    if not len(inside):
        return 0.0
    last = inside[-1]
    return float(np.interp(PEAK_GAP, gap[last:last + 2], middle[last:last + 2]))


def equilibrium(gap, shape, compliance):
    """Returns the gaps that solve g = shape + C T(g), by Newton's method from given ones; None if it fails."""
    for _ in range(60):
        _, traction, stiffness = law(gap)
        matrix = np.eye(len(gap)) - compliance * stiffness
        change = np.linalg.solve(matrix, shape + compliance @ traction - gap)
        gap = gap + min(1.0, 0.5 / max(np.max(-change / gap), 0.5)) * change
        if np.max(np.abs(change)) < 1e-10:
            return gap
    return None


def curve(tabor, width):
    """Returns approach, force over pi R W and contact radius while the sphere is pulled off, up to its jump."""
    edges = ring_edges(width, 75, 600)
    middle, area = (edges[1:] + edges[:-1]) / 2, np.pi * np.diff(edges ** 2)
    discs = np.array([np.zeros_like(middle)] + [disc(middle, a) for a in edges[1:]])
    compliance = np.diff(discs, axis=0).T
    shape = EQUILIBRIUM_GAP + middle ** 2 / (2 * RADIUS)
    # Lengths along the surface grow with the root of the Tabor number, the approach with the number itself: solutions
    # for smaller numbers, scaled, are good first guesses.
    small = min(tabor, 1.0)
    gap = shape
    for number in np.geomspace(small, tabor, 1 + int(np.ceil(10 * np.log(tabor / small)))):
        gap = EQUILIBRIUM_GAP + number / small * (np.interp(middle * (small / number) ** 0.5, middle, gap)
                                                  - EQUILIBRIUM_GAP)
        gap = equilibrium(gap, shape, compliance / modulus(number))
        small = number
    rows = []
    for approach in np.arange(0, -0.7, -0.01) * max(tabor, 0.5):
        gap = equilibrium(gap, shape - approach, compliance / modulus(tabor))
        if gap is None:
            break
        rows.append((approach, area @ law(gap)[1] / (np.pi * RADIUS * WORK), contact_radius(middle, gap)))
    return np.array(rows).T


def main():
    print(",".join(COLUMNS))
    for tabor in 0.1, 0.5, 1.0, 3.0, 5.0:
        approach, force, radius = curve(tabor, float(sys.argv[1]) if len(sys.argv) > 1 else 0.125)
        i = force.argmin()
        place, pull_off = vertex(approach, force, i)
        print(f"{tabor:g},{modulus(tabor):.6f},{-pull_off:.5f},{place:.4f},{np.interp(-place, -approach, radius):.3f}",
              flush=True)


if __name__ == "__main__":
    main()
