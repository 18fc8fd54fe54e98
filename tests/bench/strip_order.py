#!/usr/bin/python3
"""The order at which the static peak force of the strip converges with the mesh, for five elements.

    tests/bench/strip_order.py [--driver build/release/drivers/ixos] [--cells 40 80 160 320] [--along 1] [--limit F]

The right edge moves up at 1 L0/T0 almost from the start, so that rows are `step` L0 of its displacement apart. The peak is
the top of the parabola through the largest force and its neighbours; a run with half the step tells the error of sampling.
--along has that many times more cells along the strip than square ones. Errors are differences from --limit; without it,
from the limit to which Richardson's extrapolation takes the three finest meshes of quadratic cells.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import BENCH_ENVIRONMENT, ROOT, STEPS, driver_command  # noqa: E402
from newton_times import header, row  # noqa: E402

CONTACT = "Interactions/Wall/Contact Element="
QUADRATIC = "quadratic, Q2C2"
ELEMENTS = {"Q1C1": [CONTACT + "Q1C1"], "Q1C4": [CONTACT + "Q1C4"],
            "Enhanced, Q1C4": [CONTACT + "Q1C4", "Materials/Strip/Element Formulation=Enhanced"],
            QUADRATIC: [CONTACT + "Q2C2", "Mesh/Cell Order=2"],
            "quadratic, Q2C4": [CONTACT + "Q2C4", "Mesh/Cell Order=2"]}
END = 14.0  # T0; the peak lies at a displacement of 11 L0


def peak(force):
    """The top of the parabola through the largest force and its neighbours."""
    k = int(force.argmax())
    if not 0 < k < len(force) - 1:
        sys.exit("strip_order.py: the largest force is at an end of the run")
    before, largest, after = force[k - 1:k + 2]
    return largest + (after - before) ** 2 / (8 * (2 * largest - before - after))


def run(driver, element, divisions, step):
    """Degrees of freedom and peak force."""
    settings = ["Time Integrator/Type=Static", f"{STEPS}Time Step={step}", f"{STEPS}Final Time={END}",
                "Histories/Pull/Rate Ramp/Length=1", "Output/Fields Time Interval=0", "Output/Checkpoint/Keep=0",
                "Mesh/Box/Divisions={%d, %d}" % divisions, *ELEMENTS[element]]
    with tempfile.TemporaryDirectory() as folder:
        command = driver_command(driver, os.path.join(ROOT, "xml/strip.xml"), ["--output", folder], settings, 1)
        subprocess.run(command, env=BENCH_ENVIRONMENT, check=True)
        summary = json.loads((pathlib.Path(folder) / "summary.json").read_text(encoding="utf-8"))
        history = np.genfromtxt(pathlib.Path(folder) / "history.csv", delimiter=",", names=True)
    return summary["dofs"], peak(history["reaction_right_y"])


def limit(values):
    """Richardson's extrapolation of the values of three meshes, each of half the size; NaN if they do not converge."""
    if len(values) < 3:
        return np.nan
    first, second = values[-2] - values[-3], values[-1] - values[-2]
    return values[-1] + second ** 2 / (first - second) if abs(second) < abs(first) and first * second > 0 else np.nan


def measure(options):
    """Meshes, degrees of freedom and peaks by element."""
    found = {}
    for element in ELEMENTS:
        meshes = [(count * options.along, count // 20) for count in options.cells]
        found[element] = [(f"{mesh[0]} x {mesh[1]}", *run(options.driver, element, mesh, options.step)) for mesh in meshes]
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--driver", default=os.path.join(ROOT, "build/release/drivers/ixos"))
    parser.add_argument("--cells", type=int, nargs="+", default=[40, 80, 160, 320], help="along 200 L0, each twice the last")
    parser.add_argument("--along", type=int, default=1, help="this many times finer along than across")
    parser.add_argument("--step", type=float, default=0.05, help="displacement of the edge between two rows, in L0")
    parser.add_argument("--limit", type=float, help="peak force of an infinitely fine mesh")
    options = parser.parse_args()
    found = measure(options)
    limits = {element: limit([value for _, _, value in rows]) for element, rows in found.items()}
    print("Limits: " + "; ".join(f"{element} {value:.7f}" for element, value in limits.items()) + "\n")
    exact = options.limit or limits[QUADRATIC]
    header("element", "mesh", "degrees of freedom", "peak force", "error", "order")
    for element, rows in found.items():
        last = None
        for mesh, dofs, value in rows:
            error = value - exact
            row(element, mesh, f"{dofs:,}", f"{value:.7f}", f"{error:.1e}",
                "" if last is None else f"{np.log2(abs(last / error)):.1f}")
            last = error


if __name__ == "__main__":
    main()
