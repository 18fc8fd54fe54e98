#!/usr/bin/python3
"""Draws the traction and the gap along the foot of pillars at their largest force (dashed: at half of it), and says
where they come off.

    docs/tutorials/mushroom-pillar/foot.py RESULTS... [OUTPUT.png]"""
import sys

import ixos
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def foot(results, frame):
    """Returns radius [um], traction [kPa], positive in tension, and gap [nm] of the nodes of the foot, by radius."""
    fields = results.fields
    nodes = fields.nodes("bottom")
    nodes = nodes[np.argsort(fields.points[nodes, 0])]
    return (fields.points[nodes, 0], -1000 * fields.at("contact_pressure", frame)[nodes],
            1000 * fields.at("gap", frame)[nodes])


def force(radius, traction):
    """Returns the integral over the foot [uN]: Simpson's rule, which is exact for sides of quadratic cells."""
    ring = 2 * np.pi * radius * traction / 1000
    return np.sum((radius[2::2] - radius[:-2:2]) / 6 * (ring[:-2:2] + 4 * ring[1::2] + ring[2::2]))


def main():
    folders = [name for name in sys.argv[1:] if not name.endswith(".png")]
    output = next((name for name in sys.argv[1:] if name.endswith(".png")), "foot.png")
    figure, (above, below) = pyplot.subplots(2, 1, sharex=True, figsize=(5, 5), layout="constrained")
    for folder in folders:
        results = ixos.results(folder)
        row = int(np.argmax(results["reaction_top_y"]))
        frame = results.fields.frame(results["time"][row])
        time = results.fields.times[frame]
        radius, traction, gap = foot(results, frame)
        reaction = np.interp(time, results["time"], results["reaction_top_y"])
        print(f"{folder}: largest force {results['reaction_top_y'][row]:.2f} uN at {results['time'][row]:.2f} s")
        print(f"  foot at {time:.1f} s: {force(radius, traction):.3f} of {reaction:.3f} uN, "
              f"largest gap {gap.max():.0f} nm at r = {radius[gap.argmax()]:.1f} um")
        line, = above.plot(radius, traction, label=folder)
        below.plot(radius, gap, color=line.get_color())
        half = int(np.argmax(results["reaction_top_y"] > results["reaction_top_y"][row] / 2))
        radius, traction, gap = foot(results, results.fields.frame(results["time"][half]))
        above.plot(radius, traction, "--", linewidth=1, color=line.get_color())
        below.plot(radius, gap, "--", linewidth=1, color=line.get_color())
    above.set(ylabel="traction [kPa]")
    below.set(xlabel="radius [µm]", ylabel="gap [nm]")
    above.legend()
    figure.savefig(output, dpi=150)


if __name__ == "__main__":
    main()
