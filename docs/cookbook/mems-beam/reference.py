"""Pull-in of an elastic beam above an electrode, from the equation of the beam, not from finite elements.

With x over the length L, u the deflection over the electric gap z: u'''' = load/(1 - u)^2 + n u'', where
load = e L^4/(2 E' I z^3), e = permittivity times squared voltage, and n = stretch times the integral of u'^2,
stretch = 6 (z/thickness)^2: the tension of a beam held at both ends (Senturia 2001, chapter 17). A cantilever has none.
Given the largest deflection, collocation finds the load; pull-in is the largest load."""
import numpy as np
from scipy.integrate import solve_bvp
from scipy.optimize import brentq, minimize_scalar

LENGTH, THICKNESS, YOUNG, POISSON = 200e-6, 2e-6, 160e9, 0.22  # of xml/mems-beam.xml, in SI units
PERMITTIVITY, INSULATION = 8.8541878128e-12, 0.05e-6
BENDING = YOUNG / (1 - POISSON**2) * THICKNESS**3 / 12  # E' I per width
RUNS = [("cantilever", 10), ("cantilever", 20), ("cantilever", 30), ("bridge", 60), ("bridge", 100)]


def load(kind, deflection, stretch=0.0):
    """Returns the load at which the beam's largest deflection over the gap has this value."""
    def slope(x, y, unknown):
        return np.vstack([y[1], y[2], y[3], unknown[0] / (1 - y[0])**2 + unknown[1] * y[2], y[1]**2])

    def ends(a, b, unknown):  # a: the clamp; b: the free end, or the middle of the bridge
        free = (b[2], b[3], unknown[1]) if kind == "cantilever" else (b[1], b[3], unknown[1] - 2 * stretch * b[4])
        return np.array([a[0], a[1], a[4], b[0] - deflection, *free])

    x = np.linspace(0, 1 if kind == "cantilever" else 0.5, 41)
    shape = np.zeros((5, 41))
    shape[0] = deflection * (x / x[-1])**2
    found = solve_bvp(slope, ends, x, shape, [1.0, 0.0], tol=1e-8, max_nodes=20000)
    if not found.success:
        raise RuntimeError(found.message)
    return found.p[0]


def pull_in(kind, stretch=0.0):
    """Returns load and deflection at pull-in."""
    best = minimize_scalar(lambda deflection: -load(kind, deflection, stretch), bounds=(0.3, 0.65), method="bounded",
                           options={"xatol": 1e-5})
    return -best.fun, best.x


def scale(voltage):
    """Returns load times z^3 at this voltage [m^3]."""
    return PERMITTIVITY * voltage**2 * LENGTH**4 / (2 * BENDING)


def pull_in_gap(kind, voltage):
    """Returns the electric gap z [m] at which a beam under this voltage is pulled in."""
    if kind == "cantilever":
        return (scale(voltage) / pull_in(kind)[0])**(1 / 3)
    return brentq(lambda z: scale(voltage) / z**3 - pull_in(kind, 6 * (z / THICKNESS)**2)[0], 0.7e-6, 3e-6, xtol=1e-11)


if __name__ == "__main__":
    print("beam,voltage,pull_in_gap,load,deflection")
    for beam, volts in RUNS:
        gap = pull_in_gap(beam, volts)
        at = pull_in(beam, 6 * (gap / THICKNESS)**2 if beam == "bridge" else 0)
        print(f"{beam},{volts},{1e6 * gap:.5f},{at[0]:.5f},{at[1]:.4f}")
