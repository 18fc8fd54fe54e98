"""Forces of two equal strips that are peeled apart, computed without Ixos.

The force P acts on the end of each arm, across the bond, and turns the end by the angle theta. Rice's J integral has
contributions of the ends alone, which supply what adhesion takes:
    2 [P sin(theta) + P^2 sin(theta)^2/(2 E' h) + P^2 cos(theta)^2/(2 k G h)] = W,   k G h: stiffness in shear.
At small angles this is the energy release rate of the double cantilever beam. At 90 degrees it is Kendall's (1975)
balance of both arms, 2 P + P^2/(E' h) = W: a length da of strips that comes apart moves the ends apart by 2 da.

Each strip is a beam on the law. The strips open symmetrically, and the gap grows by twice the deflection w of each: a
strip has the foundation 2 k, k the law's stiffness at equilibrium. With 1/l = (4 E' I/(2 k))^(1/4) Kanninen's (1973)
arms of the length a move apart by
    2 P/(E' I) [a^3/3 + a^2/l + a/l^2 + 1/(2 l^3)],   and the front moves at   P^2 (a + 1/l)^2/(E' I) = W.

    docs/cookbook/t-peel/reference.py > docs/cookbook/t-peel/reference.csv"""
import pathlib
import sys

import numpy as np
from scipy import sparse
from scipy.optimize import brentq
from scipy.sparse.linalg import spsolve

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from recipe import EQUILIBRIUM_GAP, WORK, law  # noqa: E402

THICKNESS, POISSON = 1.0, 0.2  # of xml/t-peel.xml
SOFT, STIFF = 8.0, 500.0  # Young's moduli of the T-peel and of the double cantilever beam
LENGTH = 60.0
CRACK = 15.0  # length of the stiff strips that does not adhere
OPENINGS = {SOFT: (12, 24, 36, 48, 60, 72), STIFF: (0.1, 2, 4, 6, 8, 12, 16)}
STIFFNESS = -law(EQUILIBRIUM_GAP)[2]  # k of the law at equilibrium


def plane(young):
    """Returns E/(1 - nu^2)."""
    return young / (1 - POISSON ** 2)


def bending(young):
    """Returns E' I per width."""
    return plane(young) * THICKNESS ** 3 / 12


def t_peel(young):
    """Returns the steady force on each arm of a T-peel."""
    return brentq(lambda p: 2 * p + p ** 2 / (plane(young) * THICKNESS) - WORK, 0, 1)


def root(young):
    """Returns the length 1/l that a linear foundation adds to the crack."""
    return (4 * bending(young) / (2 * STIFFNESS)) ** 0.25


def compliance(young, crack):
    """Returns the distance of the ends over the force, for small forces."""
    a, b = crack, root(young)
    return 2 / bending(young) * (a ** 3 / 3 + a ** 2 * b + a * b ** 2 + b ** 3 / 2)


def double_cantilever(young, opening):
    """Returns the force P of Kanninen's double cantilever beam whose front moves, at a distance of the ends.

    With A = a + 1/l: opening = 2 P/(E' I) (A^3/3 + 1/(6 l^3)) and P^2 A^2/(E' I) = W."""
    stiffness, b = bending(young), root(young)

    def excess(arm):
        force = (WORK * stiffness) ** 0.5 / arm
        return 2 * force / stiffness * (arm ** 3 / 3 + b ** 3 / 6) - opening
    return (WORK * stiffness) ** 0.5 / brentq(excess, b, 1e4)


def reissner(y, young, bonded):
    """Returns slope along the arc of deflection w, angle, moment m and force v across, and its derivatives by them.

    w' = (1 + stretch) sin + shear cos, angle' = m/(E' I), m' = -v x', v' = attraction (Reissner's beam)."""
    w, angle, moment, force = y
    axial, across = plane(young) * THICKNESS, 5 / 6 * young / (2 * (1 + POISSON)) * THICKNESS
    sine, cosine = np.sin(angle), np.cos(angle)
    stretch, shear = 1 + force * sine / axial, force * cosine / across
    x, y_ = stretch * cosine - shear * sine, stretch * sine + shear * cosine
    stretch_by, shear_by = force * cosine / axial, -force * sine / across  # derivatives by the angle
    _, traction, stiffness = law(EQUILIBRIUM_GAP + 2 * w)
    slope = np.array([y_, moment / bending(young), -force * x, np.where(bonded, -traction, 0)])
    by = np.zeros((4, 4, len(w)))
    by[0, 1] = x + stretch_by * sine + shear_by * cosine
    by[0, 3] = sine ** 2 / axial + cosine ** 2 / across
    by[1, 2] = 1 / bending(young)
    by[2, 1] = -force * (-y_ + stretch_by * cosine - shear_by * sine)
    by[2, 3] = -x - force * (sine * cosine / axial - cosine * sine / across)
    by[3, 0] = np.where(bonded, -2 * stiffness, 0)
    return slope, by


def beam_on_the_law(young, openings, crack=0.0, spacing=0.05):
    """Solves an arm before its mirror image under the law, for rising openings of the ends, by midpoint differences.

    Returns the force and the angle of the end."""
    cells = round(LENGTH / spacing)
    middle = (np.arange(cells) + 0.5) * spacing
    bonded = middle < LENGTH - crack
    rows = np.repeat(np.arange(4 * cells).reshape(cells, 4), 4, axis=1).ravel()
    columns = np.tile(np.arange(4 * cells).reshape(cells, 4), (1, 4)).ravel()
    unit, ends = np.eye(4)[:, :, None], np.arange(4 * cells, 4 * cells + 4)
    place = np.array([0, 1, 4 * cells, 4 * cells + 2])  # w and the angle of the held end; w and m of the pulled one

    def solve(y, opening):
        for _ in range(60):
            slope, by = reissner((y[:, 1:] + y[:, :-1]) / 2, young, bonded)
            residual = np.append((y[:, 1:] - y[:, :-1] - spacing * slope).T.ravel(),
                                 [y[0, 0], y[1, 0], y[0, -1] - opening / 2, y[2, -1]])
            first, second = (np.moveaxis(sign * unit - spacing / 2 * by, 2, 0).ravel() for sign in (-1, 1))
            matrix = sparse.csc_matrix((np.concatenate([first, second, np.ones(4)]),
                                        (np.concatenate([rows, rows, ends]),
                                         np.concatenate([columns, columns + 4, place]))))
            change = -spsolve(matrix, residual).reshape(-1, 4).T
            inward = np.max(-2 * change[0] / (EQUILIBRIUM_GAP + 2 * y[0]))
            y = y + min(1, 0.5 / max(inward, 0.5)) * change
            if np.max(np.abs(change[0])) < 1e-10:
                return y
        raise RuntimeError(f"no equilibrium at the opening {opening:g}")

    y, forces, angles = np.zeros((4, cells + 1)), [], []
    small = np.concatenate([np.geomspace(0.01, 0.5, 20), np.arange(0.75, max(openings), 0.5)])
    for opening in np.unique(np.concatenate([small, openings]).round(9)):
        y = solve(y, opening)
        if np.any(np.isclose(opening, openings)):
            forces.append(y[3, -1])
            angles.append(y[1, -1])
    return np.array(forces), np.array(angles)


def main():
    print("modulus,crack,opening,force,angle")
    for young, crack in ((STIFF, CRACK), (SOFT, 0.0)):
        for opening, force, angle in zip(OPENINGS[young],
                                         *beam_on_the_law(young, np.array(OPENINGS[young], dtype=float), crack)):
            print(f"{young:g},{crack:g},{opening:g},{force:.6f},{angle:.5f}", flush=True)


if __name__ == "__main__":
    main()
