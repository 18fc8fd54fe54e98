#!/usr/bin/python3
"""Computes the table of laws_test.cpp with 50 digits.

    tests/interaction/law_values.py

needs mpmath. Each law is given by its energy psi alone: tractions are derivatives, means are differences of energies,
and the potential of the mean is an integral.
"""
from mpmath import cos, diff, e, exp, log, mp, mpf, pi, quad

mp.dps = 50


def step(t):
    """Returns the integral of 1 - t^2 (3 - 2 t) from t to 1, with 1 before 0 and 0 after 1."""
    if t >= 1:
        return mpf(0)
    if t <= 0:
        return mpf(1) / 2 - t
    return mpf(1) / 2 - t + t**3 - t**4 / 2


def plateau(strength, range_, ramp):
    return lambda g: -strength * 2 * ramp * step((g - range_ + ramp) / (2 * ramp))


def mie(n, m, work, gap):
    return lambda g: work * (m * (gap / g)**n - n * (gap / g)**m) / (n - m)


def mie_gap(n, m, work, strength):
    ratio = ((m + 1) / (n + 1))**(1 / (n - m))
    return n * m / (n - m) * (ratio**(m + 1) - ratio**(n + 1)) * work / strength


def xu_needleman(work, length, gap):
    return lambda g: -work * (1 + (g - gap) / length) * exp(-(g - gap) / length)


def barrier(stiffness, range_):
    return lambda g: -stiffness * (g - range_)**2 * log(g / range_) if g < range_ else mpf(0)


def penalty(stiffness, gap):
    return lambda g: stiffness * (gap - g)**2 / 2 if g < gap else mpf(0)


def triangle(strength, peak, end):
    def energy(g):
        if g >= end:
            return mpf(0)
        if g >= peak:
            return -strength * (end - g)**2 / (end - peak) / 2
        rest = -strength * (end - peak) / 2
        return rest - strength * (peak - max(g, 0)**2 / peak) / 2
    return energy


W, S, R = mpf("0.02"), mpf("0.07"), mpf("0.3")
humid = -mpf("0.0686") * log(mpf("0.5"))  # Laplace pressure
height = 2 * mpf("0.036") / humid * cos(20 * pi / 180)

LAWS = [  # name, settings, energy, gaps at which it is not smooth
    ("Mie", '{"Repulsive Exponent", 9.5}, {"Attractive Exponent", 2.25}, {"Work of Adhesion", 0.02}, {"Strength", 0.07}',
     mie(mpf("9.5"), mpf("2.25"), W, mie_gap(mpf("9.5"), mpf("2.25"), W, S)), []),
    ("Mie", '{"Constants", "Hamaker"}, {"Hamaker Constant", 0.05}, {"Equilibrium Gap", 0.3}, {"Repulsive Exponent", 6.0}',
     mie(mpf(6), mpf(2), mpf("0.05") * 4 / (12 * pi * 6 * R**2), R), []),
    ("Mie", '{"Constants", "Gap"}, {"Work of Adhesion", 0.02}, {"Equilibrium Gap", 0.3}, {"Repulsive Exponent", 2.001}',
     mie(mpf(2.001), mpf(2), W, R), []),
    ("Xu-Needleman", '{"Work of Adhesion", 0.02}, {"Strength", 0.07}, {"Equilibrium Gap", 0.3}',
     xu_needleman(W, W / (e * S), R), []),
    ("Xu-Needleman", '{"Constants", "Length"}, {"Work of Adhesion", 0.02}, {"Characteristic Length", 1.5}',
     xu_needleman(W, mpf("1.5"), mpf("0.2547093")), []),
    ("Smooth Dugdale", '{"Work of Adhesion", 0.02}, {"Strength", 0.07}, {"Smoothing", 0.3}',
     plateau(S, W / S, mpf("0.3") * W / S), [W / S * mpf("0.7"), W / S * mpf("1.3")]),
    ("Smooth Dugdale", '{"Constants", "Range"}, {"Range", 0.3}, {"Strength", 0.07}, {"Smoothing", 1e-3}',
     plateau(S, R, R / 1000), [R - R / 1000, R + R / 1000]),
    ("Triangle", '{"Work of Adhesion", 0.02}, {"Strength", 0.07}, {"Peak Gap", 0.21}',
     triangle(S, mpf("0.21"), 2 * W / S), [mpf("0.21"), 2 * W / S]),
    ("Electrostatic", '{"Voltage", 2.0}, {"Permittivity", 0.005}, {"Insulation", 0.1}',
     lambda g: -mpf("0.02") / (2 * (g + mpf("0.1"))), []),
    ("Capillary", '{"Surface Tension", 0.036}, {"Relative Humidity", 0.5}, {"Kelvin Pressure", 0.0686}, '
     '{"Contact Angle", 20.0}', plateau(humid, height, height / 5), [height * 4 / 5, height * 6 / 5]),
    ("Penalty", '{"Stiffness", 30.0}, {"Gap", 0.31}', penalty(mpf(30), mpf("0.31")), [mpf("0.31")]),
    ("Log Barrier", '{"Stiffness", 2.5}, {"Range", 0.31}', barrier(mpf("2.5"), mpf("0.31")), [mpf("0.31")]),
]
PATHS = [("0.2", "0.7"), ("0.7", "0.2"), ("0.25", "0.2500001"), ("0.28", "0.33"), ("0.02", "0.4"), ("1.2", "0.1")]


def potential(psi, a, b, breaks):
    def slope(g):
        return (psi(g) - psi(a)) / (g - a) if g != a else diff(psi, a)
    return quad(slope, [a, *sorted((k for k in breaks if min(a, b) < k < max(a, b)), reverse=b < a), b])


def main():
    for name, settings, psi, breaks in LAWS:
        print(f'    {{"{name}", {{{settings}}}, {{')
        for start, end in PATHS:
            a, b = mpf(float(start)), mpf(float(end))

            def mean(g):
                return (psi(a) - psi(g)) / (g - a)
            values = [psi(b), -diff(psi, b), diff(psi, b, 2), mean(b), -diff(mean, b), potential(psi, a, b, breaks)]
            print(f"        {{{start}, {end}, {{" + ", ".join(mp.nstr(x, 17) for x in values) + "}},")
        print("    }},")


if __name__ == "__main__":
    main()
