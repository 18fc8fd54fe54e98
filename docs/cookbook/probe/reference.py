"""The sphere of xml/probe.xml by Johnson, Kendall and Roberts (1971) on a spring: closed forms in um, MPa and ms."""
import math

import numpy as np

RADIUS, MODULUS, STIFFNESS = 7.5, 1.84, 3.01  # R, E/(1 - nu^2), K
MASS, DAMPING = 0.02, 0.025


def branch(work, radii):
    """Returns indentation and force, positive for pressure, at radii of contact."""
    radii = np.asarray(radii)
    inside = np.sqrt(2 * math.pi * work * radii / MODULUS)
    return radii**2 / RADIUS - inside, 4 * MODULUS * radii**3 / (3 * RADIUS) - 2 * MODULUS * radii * inside


def depths(work, radii):
    """Returns how far the spring's base is below the place where the sphere touches, and the force."""
    indentation, force = branch(work, radii)
    return indentation + force / STIFFNESS, force


def stable(work, largest=4.0):
    """Returns the radii of contact, upwards, of the equilibria on that spring that are stable."""
    radii = np.linspace(0.02, largest, 200001)
    base = depths(work, radii)[0]
    return radii[int(base.argmin()):]


def at_depth(work, depth):
    """Returns the force where the base is at a depth."""
    base, force = depths(work, stable(work))
    return float(np.interp(depth, base, force))


def zero(work):
    """Returns the depth of the base without a force, where the contact has the radius (9 pi W R^2/2 E*)^(1/3)."""
    radius = (9 * math.pi * work * RADIUS**2 / (2 * MODULUS))**(1 / 3)
    return float(depths(work, radius)[0])


def release(work):
    """Returns the height of the base, and the force, where the last equilibrium ends."""
    base, force = depths(work, stable(work))
    return -float(base[0]), float(force[0])


def pull(work):
    """Returns the strongest pull, -3/2 pi R W."""
    return -1.5 * math.pi * RADIUS * work


def ring():
    """Returns the period of the free probe on its spring and dashpot."""
    return 2 * math.pi / math.sqrt(STIFFNESS / MASS - (DAMPING / (2 * MASS))**2)
