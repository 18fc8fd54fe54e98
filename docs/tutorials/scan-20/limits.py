#!/usr/bin/python3
"""Runs the scan of docs/tutorials/scan-20 in Python, and draws the pull-off force with its two limits: limits.png.

    docs/tutorials/scan-20/limits.py"""
import ixos
import numpy as np
from scipy.optimize import brentq

FOOT = np.pi * 10**2  # [um^2]


def exponent(nu):
    """Returns the power of the strength that a strong bond holds, 2 lambda - 1: displacements at the corner of the foot
    grow as the distance to the power lambda, the root of k sin(lambda pi/2)^2 = (k + 1)^2/4 - lambda^2, k = 3 - 4 nu
    (Williams 1952: one face free, one held, 90 degrees between them)."""
    k = 3 - 4 * nu
    root = brentq(lambda x: k * np.sin(x * np.pi / 2)**2 - (k + 1)**2 / 4 + x * x, 0.4, 0.9)
    return 2 * root - 1


def main():
    table = ixos.scan("docs/tutorials/scan-20/scan-20.xml",
                      {"Interactions/Adhesion/Smooth Dugdale/Strength": "0.005:0.5:20:log"}, jobs=2,
                      observer=lambda row, done, reused: print(done, row["name"], "reused" if reused else "run"))
    strength, force = table["Strength"], table["peak reaction_top_y"]
    weak, strong = strength < 0.05, strength > 0.1
    print(f"weak bonds: force/(strength times foot) = {np.min(force[weak] / (strength[weak] * FOOT)):.9f} to "
          f"{np.max(force[weak] / (strength[weak] * FOOT)):.9f}")
    slope = np.polyfit(np.log(strength[strong]), np.log(force[strong]), 1)[0]
    print(f"strong bonds: exponent {slope:.4f}, corner {exponent(0.49):.4f}")
    draw(strength, force, strong)


def draw(strength, force, strong):
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(5, 3.5), layout="constrained")
    axes.loglog(1000 * strength, force, "o", markersize=4, label="Ixos")
    axes.loglog(1000 * strength, strength * FOOT, "--", color="0.3", label="strength times foot")
    power = force[strong][0] * (strength / strength[strong][0])**exponent(0.49)
    axes.loglog(1000 * strength, power, ":", color="0.3", label="singularity at the edge")
    axes.set(xlabel="strength [kPa]", ylabel="pull-off force [µN]", ylim=(1, 100))
    axes.legend(frameon=False)
    figure.savefig("limits.png", dpi=150)


if __name__ == "__main__":
    main()
