#!/usr/bin/python3
"""Checks the errors that ixos --accuracy reports: the true error of each quantity is at most the reported one, and that is
within the accuracy (10 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/verification/accuracy_test.py

The oscillator beside this file has one degree of freedom and a solution in closed form, u = v/w exp(-alpha t/2) sin(w t)
with w^2 = k/m - alpha^2/4 and Rayleigh damping alpha of its mass. The stiffness k is 1, the mass m is 1/3, lumped 1/2. A
short strip is compared with much shorter fixed steps.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in ("tests/support", "drivers/plot")]
from driver_process import ENVIRONMENT, STEPS, driver_command  # noqa: E402
from result_files import read_history, read_summary  # noqa: E402

DRIVER = os.environ.get("IXOS_DRIVER", str(ROOT / "build/release/drivers/ixos"))
OSCILLATOR = ROOT / "tests/verification/oscillator.xml"
SCHEME = "Time Integrator/Type="
STRIP = [STEPS + "Final Time=10", "Histories/Pull/Rate Ramp/Length=5", "Mesh/Box/Divisions={80, 4}",
         "Output/Fields Time Interval=0"]


def oscillation(mass, damping):
    """Returns the exact values of the oscillator's quantities."""
    w = math.sqrt(1 / mass - damping ** 2 / 4)

    def displacement(t):
        return 0.1 / w * math.exp(-damping * t / 2) * math.sin(w * t)

    def velocity(t):
        return 0.1 * math.exp(-damping * t / 2) * (math.cos(w * t) - damping / 2 / w * math.sin(w * t))
    root = math.sqrt(3)  # the displacement is linear in x
    return {"final P_ux": displacement(5), "final norm_displacement": abs(displacement(5)) / root,
            "value norm_velocity at 2.5": abs(velocity(2.5)) / root, "peak P_ux": displacement(math.atan2(w, damping / 2) / w),
            "time of P_ux below 0": math.pi / w}


def accuracy(scene, settings, asked, folder, ranks=1):
    """Returns the object "accuracy" of a run to an accuracy."""
    command = driver_command(DRIVER, str(scene), ["--output", folder, "--accuracy", asked], settings, ranks)
    subprocess.run(command, env=ENVIRONMENT, check=True)
    return read_summary(pathlib.Path(folder, "summary.json"))["accuracy"]


def problems(name, found, exact):
    """Yields messages on errors that are larger than they were said to be."""
    for own in found["quantities"]:
        error = abs(own["value"] / exact[own["quantity"]] - 1)
        print(f"{name}: {own['quantity']}: error {error:.2g}, reported {own['error']:.2g}", flush=True)
        if error > own["error"]:
            yield f"{name}: {own['quantity']} has a larger error than reported"
        if own["error"] > found["asked"]:
            yield f"{name}: {own['quantity']} is not within the accuracy"
    if not found["quantities"] or not found["kept"]:
        yield f"{name}: nothing is kept"


def oscillators(folder):
    """Yields the problems of the oscillator with several schemes, with and without damping, on one and two ranks."""
    schemes = ("Average Vector Field", "Newmark", "Bathe Composite", "Generalized-Alpha", "Central Difference")
    cases = [(scheme, 0, asked, 1) for scheme in schemes for asked in ("1%", "0.01%")]
    cases += [("Newmark", 0.4, "0.1%", 1), ("Newmark", 0.4, "0.1%", 2)]
    for number, (scheme, damping, asked, ranks) in enumerate(cases):
        settings = [SCHEME + scheme, f"Materials/Cell/Mass Damping={damping}", f"Mesh/Box/Divisions={{1, {2 * ranks}}}"]
        found = accuracy(OSCILLATOR, settings, asked, f"{folder}/{number}", ranks)
        mass = 1 / 2 if scheme == "Central Difference" else 1 / 3
        name = f"oscillator, {scheme}, damping {damping}, {asked}, {ranks} rank(s)"
        yield from problems(name, found, oscillation(mass, damping))


def strip(folder):
    """Yields the problems of a short strip."""
    fine = driver_command(DRIVER, str(ROOT / "xml/strip.xml"), ["--output", folder + "/fine"],
                          STRIP + [STEPS + "Time Step=0.002"], 1)
    subprocess.run(fine, env=ENVIRONMENT, check=True)
    history = read_history(pathlib.Path(folder, "fine/history.csv"))
    exact = {"peak reaction_right_y": np.nanmax(np.abs(history["reaction_right_y"])),
             "work": history["external_work"][-1]}
    found = accuracy(ROOT / "xml/strip.xml", STRIP + ["Output/Quantities={" + ", ".join(exact) + "}"], "0.3%",
                     folder + "/strip")
    yield from problems("strip", found, exact)


def main():
    with tempfile.TemporaryDirectory(prefix="ixos-accuracy-") as folder:
        found = [*oscillators(folder), *strip(folder)]
    for problem in found:
        print(problem)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
