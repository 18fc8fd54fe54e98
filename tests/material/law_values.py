#!/usr/bin/python3
"""Computes the table of rubber_laws_test.cpp with 60 digits.

    tests/material/law_values.py

needs mpmath. Each law is given by its energy alone, in the invariants and the eigenvalues of C; the stress is a
derivative.
"""
from mpmath import diff, eigsy, log, matrix, mp, mpf

mp.dps = 60

SAMPLE = ((0.3, -0.2, 0.25), (0.5, -0.4, 0.1), (-0.15, 0.35, 0.45))
SIZES = (1e-8, 1e-3, 1.0)
POISSON = mpf(0.3)  # the constants of the test are doubles, too


def isochoric(h):
    """Returns I1 - 3 and I2 - 3 of Cb, the squares of its stretches, and J."""
    f = matrix([[h[i][j] + (i == j) for j in range(3)] for i in range(3)])
    volume = mp.det(f)
    c = f.T * f * volume ** (-mpf(2) / 3)
    first = c[0, 0] + c[1, 1] + c[2, 2]
    square = c * c
    second = (first**2 - square[0, 0] - square[1, 1] - square[2, 2]) / 2
    return first - 3, second - 3, c, volume


def ogden(c, terms):
    stretches = [value ** (mpf(1) / 2) for value in eigsy(c, eigvals_only=True)]
    return sum(mu / a * (sum(stretch**a for stretch in stretches) - 3) for mu, a in terms)


OGDEN = ((mpf(1.5), mpf(1.3)), (mpf(-0.1), mpf(-2)))
LAWS = {  # the shear modulus, and the energy of the shape
    "Mooney-Rivlin": (2 * (mpf(0.35) + mpf(0.15)), lambda x, y, c: mpf(0.35) * x + mpf(0.15) * y),
    "Yeoh": (mpf(1), lambda x, y, c: x / 2 + mpf(-0.05) * x**2 + mpf(0.02) * x**3),
    "Gent": (mpf(1), lambda x, y, c: -mpf(5) / 2 * log(1 - x / 5)),
    "Ogden": (sum(mu * a for mu, a in OGDEN) / 2, lambda x, y, c: ogden(c, OGDEN)),
}
VOLUMETRIC = {"Logarithm": lambda bulk, j: bulk / 2 * log(j) ** 2,
              "Convex": lambda bulk, j: bulk / 4 * (j**2 - 1 - 2 * log(j))}


def main():
    for name, (shear, shape) in LAWS.items():
        bulk = 2 * shear * (1 + POISSON) / (3 * (1 - 2 * POISSON))
        for form, volume in VOLUMETRIC.items():
            energies, stresses = [], []
            for size in SIZES:
                h = [[mpf(size * value) for value in row] for row in SAMPLE]

                def energy(shear_01):
                    moved = [list(row) for row in h]
                    moved[0][1] = shear_01
                    x, y, c, j = isochoric(moved)
                    return shape(x, y, c) + volume(bulk, j)
                energies.append(energy(h[0][1]))
                stresses.append(diff(energy, h[0][1], h=mpf(10) ** -20))
            numbers = [", ".join(mp.nstr(value, 18) for value in values) for values in (energies, stresses)]
            print(f'{{"{name}", "{form}", {{{numbers[0]}}}, {{{numbers[1]}}}}},')


if __name__ == "__main__":
    main()
