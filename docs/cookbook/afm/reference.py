"""Jump-in and jump-out of a rigid cap on a spring, in closed form.

The wall attracts a unit of surface at a gap g with the energy psi(g), traction T = -psi'. A spherical cap of radius R,
cut off at a height h above its apex, has the force F(D) = 2 pi R [psi(D) - psi(D + h)] away from the wall at the apex
gap D, exactly (Derjaguin 1934 without his approximation, since each unit of the cap's surface counts). The cantilever's
base stands at the height Z above the contact, k (Z - D) + F(D) = 0. The equilibrium ends where dF/dD = k: on the far
side of the largest attraction the tip jumps in, on the near side it jumps out (Israelachvili 2011, section 12.10)."""
import math

from scipy.optimize import brentq, minimize_scalar

RADIUS, HEIGHT = 10.0, 4.0  # of xml/afm.xml [nm]
HAMAKER, LENGTH = 1e-19 / (2e9 * 1e-27), 0.4  # [E0 L0^3], [L0]
SCALE = HAMAKER / (2 * math.pi**2 * LENGTH**3)  # W0 [E0]
STIFFNESSES = (0.05, 0.1, 0.5)  # of the cantilever [2 N/m]


def traction(gap):
    """Returns the traction, positive if it repels (Sauer and Wriggers 2009)."""
    ratio = LENGTH / gap
    return math.pi * SCALE * (ratio**9 / 45 - ratio**3 / 3)


def energy(gap):
    """Returns psi."""
    ratio = LENGTH / gap
    return math.pi * SCALE * LENGTH * (ratio**8 / 360 - ratio**2 / 6)


def force(gap):
    """Returns the force on the cap at an apex gap."""
    return 2 * math.pi * RADIUS * (energy(gap) - energy(gap + HEIGHT))


def slope(gap):
    """Returns dF/dD."""
    return -2 * math.pi * RADIUS * (traction(gap) - traction(gap + HEIGHT))


def base(gap, stiffness):
    """Returns the height of the base in equilibrium with an apex gap."""
    return gap - force(gap) / stiffness


def jumps(stiffness):
    """Returns (gap, height of the base) at jump-in and at jump-out."""
    steepest = minimize_scalar(lambda gap: -slope(gap), bounds=(0.2, 1), method="bounded").x
    gaps = [brentq(lambda gap: slope(gap) - stiffness, *ends) for ends in ((steepest, 10), (0.15, steepest))]
    return [(gap, base(gap, stiffness)) for gap in gaps]


if __name__ == "__main__":
    print("stiffness,gap_in,base_in,gap_out,base_out,force_out")
    for k in STIFFNESSES:
        (gap_in, base_in), (gap_out, base_out) = jumps(k)
        print(f"{k},{gap_in:.5f},{base_in:.5f},{gap_out:.5f},{base_out:.5f},{-force(gap_out):.6f}")
