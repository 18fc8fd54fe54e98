#!/usr/bin/python3
"""Force on a rigid cap above rough walls, by quadrature over the exact cap: references of xml/afm-rough.xml.

    docs/cookbook/afm/rough.py > docs/cookbook/afm/rough.csv
    docs/cookbook/afm/rough.py scan > docs/cookbook/afm/scan.csv      writes the scan, xml/afm-rough.gsf, too

A wall is a sum of waves A cos(k x + m y + phase), (A, k, m, phase) each: two waves that cross, or the surface of the
scan, whose waves have random phases and amplitudes as of a self-affine surface, with the Hurst exponent 0.8."""
import pathlib
import sys

import numpy as np
import reference

APEX, HALF_WIDTH, CUTOFF = 1.1, 6.0, 4.0
POINTS = 80  # Gauss points along each direction
CROSSING = [(0.3, 2 * np.pi / 8, 0, 0), (0.3, 0, 2 * np.pi / 8, 0)]
PERIOD, SAMPLES, LONGEST, CREST = 16.0, 32, 0.2, 0.6  # of the scan: period, heights along it, amplitude, highest height


def bent(waves, a, b):
    """Returns heights, slopes along x and y, and second derivatives by xx, yy and xy of a wall."""
    height, *rest = [np.zeros_like(a) for _ in range(6)]
    for amplitude, k, m, phase in waves:
        cosine, sine = (amplitude * function(k * a + m * b + phase) for function in (np.cos, np.sin))
        height += cosine
        for sums, part in zip(rest, (-k * sine, -m * sine, -k * k * cosine, -m * m * cosine, -k * m * cosine)):
            sums += part
    return height, rest[:2], rest[2:]


def grid():
    """Returns the places of the scan's heights, from the greatest y, and along x."""
    place = PERIOD / SAMPLES * (np.arange(SAMPLES) - (SAMPLES - 1) / 2)
    return np.meshgrid(place, place[::-1])


def scanned():
    """Returns the waves of the scan and one without length, which lifts its highest height to CREST."""
    vectors = [(m, n) for m in range(4) for n in range(-3, 4) if 0 < m * m + n * n < 10 and (m > 0 or n > 0)]
    phases = 2 * np.pi * np.random.RandomState(1).random_sample(len(vectors))
    waves = [(LONGEST * np.hypot(m, n) ** -1.8, 2 * np.pi / PERIOD * m, 2 * np.pi / PERIOD * n, phase)
             for (m, n), phase in zip(vectors, phases)]
    return waves + [(CREST - bent(waves, *grid())[0].max(), 0, 0, 0)]


def write_scan(path):
    """Writes the heights of the scan as a Gwyddion Simple Field."""
    header = (f"Gwyddion Simple Field 1.0\nXRes = {SAMPLES}\nYRes = {SAMPLES}\nXReal = {PERIOD:g}e-9\n"
              f"YReal = {PERIOD:g}e-9\nXYUnits = m\nZUnits = m\nTitle = Self-affine surface\n").encode()
    heights = (1e-9 * bent(scanned(), *grid())[0]).astype("<f4")
    path.write_bytes(header + bytes(4 - len(header) % 4) + heights.tobytes())


def foot(waves, x, y, z):
    """Returns the point of the wall nearest to each point, by Newton's method from the point below."""
    a, b = x.copy(), y.copy()
    for _ in range(60):
        height, slope, (bend_x, bend_y, bend_xy) = bent(waves, a, b)
        right = [x - a + (z - height) * slope[0], y - b + (z - height) * slope[1]]
        xx, yy, xy = (1 + slope[0]**2 - (z - height) * bend_x, 1 + slope[1]**2 - (z - height) * bend_y,
                      slope[0] * slope[1] - (z - height) * bend_xy)
        determinant = xx * yy - xy**2
        da, db = (yy * right[0] - xy * right[1]) / determinant, (xx * right[1] - xy * right[0]) / determinant
        size = np.maximum(1, np.hypot(da, db) / 0.3)  # at most 0.3 nm a step
        a, b = a + da / size, b + db / size
        if np.abs(np.concatenate([da, db])).max() < 1e-12:
            break
    return a, b, bent(waves, a, b)[0]


def force(path, waves=None):
    """Returns the force on the cap, along x, y and z, after this path along x."""
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    x, y = (HALF_WIDTH * c.ravel() for c in np.meshgrid(nodes, nodes))
    weight = HALF_WIDTH**2 * np.outer(weights, weights).ravel()
    root = np.sqrt(reference.RADIUS**2 - x**2 - y**2)
    area = weight * reference.RADIUS / root
    place = np.array([x + path, y, APEX + reference.RADIUS - root])
    offset = place - np.array(foot(waves or CROSSING, *place))
    gap = np.linalg.norm(offset, axis=0)
    traction = np.where(gap < CUTOFF, reference.traction(gap) - reference.traction(CUTOFF), 0)  # a shifted force
    return [float((traction * area * component / gap).sum()) for component in offset]


if __name__ == "__main__":
    scan = sys.argv[1:] == ["scan"]
    if scan:
        write_scan(pathlib.Path(__file__).resolve().parents[3] / "xml/afm-rough.gsf")
    print("path,force_x,force_z")
    for travelled in (0, 3, 6, 9, 12) if scan else (0, 1, 2, 3, 4):
        along, _, up = force(travelled, scanned() if scan else CROSSING)
        print(f"{travelled},{along:.6f},{up:.6f}")
