"""Computes reference.csv without Ixos: two equal elastic cylinders under the law, by strips of pressure.

    docs/cookbook/cylinders/reference.py > docs/cookbook/cylinders/reference.csv

The gap at x_i is g_i = r_eq - delta + x_i^2/(2 R) + sum_j C_ij T(g_j). Both bodies together have 1/R and 1/E*, and C_ij
is the displacement of a half-plane at x_i by unit pressures on the strips j and -j (Johnson 1985, section 2.7),
-2/(pi E*) int ln(|x - s|/D) ds. The length D moves the approach delta but no force."""
import pathlib
import sys

import numpy as np
from scipy.integrate import quad

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("jkr", ".")]
from half_space import contact_radius, equilibrium, ring_edges  # noqa: E402
from recipe import EQUILIBRIUM_GAP, WORK, law, vertex  # noqa: E402

RADIUS = 1000.0 / 2  # of both: 1/R = 1/R1 + 1/R2
DEPTH = 400.0  # D
TABOR = 0.1, 1.0, 3.0


def modulus(tabor):
    """Returns E* of both, 1/E* = 1/E1* + 1/E2*, for a Tabor number."""
    return (RADIUS * WORK ** 2 / (tabor * EQUILIBRIUM_GAP) ** 3) ** 0.5


def compliances(edges):
    """Returns E* times the displacements in the middles of strips by unit pressures on a strip and its mirror image."""
    middle = (edges[1:] + edges[:-1]) / 2

    def integral(end):  # of ln(|x - s|/D) over s, up to an end
        distance = end - middle[:, None]
        return distance * (np.log(np.abs(distance) / DEPTH) - 1)
    right = integral(edges[None, 1:]) - integral(edges[None, :-1])
    left = integral(-edges[None, :-1]) - integral(-edges[None, 1:])
    return -2 / np.pi * (right + left)


def curve(tabor, width):
    """Returns approach, force per length and half width of the contact while the cylinders are pulled apart."""
    edges = ring_edges(width, 45, 400)
    middle, strips = (edges[1:] + edges[:-1]) / 2, 2 * np.diff(edges)
    compliance, shape = compliances(edges), EQUILIBRIUM_GAP + middle ** 2 / (2 * RADIUS)
    gap, start = shape, 0.4 * tabor
    for share, stiffness in zip(np.linspace(0, 1, 200), np.geomspace(50 * modulus(0.1), modulus(tabor), 200)):
        gap = equilibrium(gap, shape - share * start, compliance / stiffness)  # from nearly rigid bodies on
    rows = []
    for approach in start - np.arange(0, 4, 0.01) * max(tabor, 0.2):
        gap = equilibrium(gap, shape - approach, compliance / modulus(tabor))
        if gap is None:
            break
        rows.append((approach, strips @ law(gap)[1], contact_radius(middle, gap)))
    return np.array(rows).T


def jkr(tabor):
    """Returns the pull-off force of Johnson, Kendall and Roberts, and the half width there (Barquins 1988)."""
    stiffness = modulus(tabor)
    return (0.75 * (4 * np.pi * stiffness * RADIUS * WORK ** 2) ** (1 / 3),
            (2 * RADIUS ** 2 * WORK / (np.pi * stiffness)) ** (1 / 3))


def rigid():
    """Returns the pull-off force of rigid cylinders: the largest integral of the law over their gap."""
    def force(gap):
        return -quad(lambda x: law(gap + x ** 2 / (2 * RADIUS))[1], 0, 200, limit=200)[0] * 2
    gaps = EQUILIBRIUM_GAP + np.arange(0, 0.1, 0.002)
    forces = np.array([force(gap) for gap in gaps])
    return vertex(gaps, forces, forces.argmax())[1]


def main():
    print("tabor,modulus,pull_off,half_width,jkr,jkr_half_width")
    print(f"0,inf,{rigid():.5f},,,")
    for tabor in TABOR:
        approach, force, radius = curve(tabor, float(sys.argv[1]) if len(sys.argv) > 1 else 0.25)
        place, pull_off = vertex(approach, force, force.argmin())
        print(f"{tabor:g},{modulus(tabor):.6f},{-pull_off:.5f},{np.interp(-place, -approach, radius):.3f},"
              f"{jkr(tabor)[0]:.5f},{jkr(tabor)[1]:.3f}", flush=True)


if __name__ == "__main__":
    main()
