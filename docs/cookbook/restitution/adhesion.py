"""What adhesion takes from a slow impact: the loop of force over approach of an elastic half-space and a paraboloid.

The ball snaps onto the wall at one approach and off it at another. Between them the force has two values. Their
difference, integrated over the approach, is lost, whatever the mass of the ball is, if it moves slowly."""
import pathlib
import sys

import numpy as np
from scipy.integrate import trapezoid
from scipy.interpolate import PchipInterpolator

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("jkr", ".")]
from half_space import RADIUS, disc, equilibrium, modulus, ring_edges  # noqa: E402
from recipe import EQUILIBRIUM_GAP, WORK, law  # noqa: E402

JUMP = 0.1 * np.pi * RADIUS * WORK  # change of the force in a step


class HalfSpace:
    """The gaps and the force at given approaches."""

    def __init__(self, stiffness, width):
        edges = ring_edges(width, 110, 700)
        middle = (edges[1:] + edges[:-1]) / 2
        self.stiffness, self.middle, self.area = stiffness, middle, np.pi * np.diff(edges ** 2)
        discs = np.array([np.zeros_like(middle)] + [disc(middle, a) for a in edges[1:]])
        self.compliance = np.diff(discs, axis=0).T
        self.shape = EQUILIBRIUM_GAP + middle ** 2 / (2 * RADIUS)

    def in_contact(self):
        """Returns the gaps at the approach 0 in contact, by way of stiffer half-spaces."""
        tabor = (RADIUS * WORK ** 2 / self.stiffness ** 2) ** (1 / 3) / EQUILIBRIUM_GAP
        small, gap = 1.0, self.shape
        for number in np.geomspace(small, tabor, 12):
            root = (small / number) ** 0.5
            gap = EQUILIBRIUM_GAP + number / small * (np.interp(self.middle * root, self.middle, gap) - EQUILIBRIUM_GAP)
            gap, small = equilibrium(gap, self.shape, self.compliance / modulus(number)), number
        return gap

    def branch(self, approach, step, gap):
        """Returns approaches and forces from one approach on, up to the jump of the force; steps shorten before it."""
        approaches, forces = [], []
        while abs(step) > 1e-4:
            found = equilibrium(gap, self.shape - approach, self.compliance / self.stiffness)
            force = None if found is None else self.area @ law(found)[1]
            if force is None or (forces and abs(force - forces[-1]) > JUMP):
                step /= 2
                approach = approaches[-1] + step
                continue
            approaches.append(approach)
            forces.append(force)
            gap = found
            approach += step
        return np.array(approaches), np.array(forces)


def loss(stiffness, width=0.5, step=0.01):
    """Returns the energy of the loop for E* = stiffness, by rings of a width and steps of the approach."""
    model = HalfSpace(stiffness, width)
    off, pull = model.branch(0.0, -step, model.in_contact())
    on, push = model.branch(-3.0, step, model.shape + 3)
    between = np.linspace(off[-1], on[-1], 2001)
    return trapezoid(PchipInterpolator(on, push)(between) - PchipInterpolator(off[::-1], pull[::-1])(between), between)


def loss_jkr(stiffness):
    """Returns the energy of the loop of Johnson, Kendall and Roberts: snap on at the approach 0, off at the least."""
    a = np.linspace((np.pi * WORK * RADIUS ** 2 / (8 * stiffness)) ** (1 / 3), 200, 400001)
    approach = a ** 2 / RADIUS - np.sqrt(2 * np.pi * WORK * a / stiffness)
    force = 4 * stiffness * a ** 3 / (3 * RADIUS) - np.sqrt(8 * np.pi * stiffness * WORK * a ** 3)
    inside = approach <= 0
    return -trapezoid(force[inside], approach[inside])
