#!/usr/bin/python3
"""The fastest settings of two checkouts for errors of 1, 0.3 and 0.1 per cent of the pull-off force of the strip or of
the stiff spatula, over a grid of meshes, cells, contact elements and steps.

usage: fastest_settings.py strip|spatula OLD NEW FOLDER [PATTERN]

OLD and NEW are checkouts with build/release. PATTERN, a regular expression, selects settings by name: the lines of
single runs have the names, the step behind them.

The error is the rms error of the force in a window, against fine quadratic cells, which NEW computes once (FOLDER keeps
them). The error of a setting is the largest at its step and all smaller ones. Runs come one at a time, OLD and NEW in
turns. The time is that of the whole process on an idle machine, its start included; the table has the processor time,
too. The strip runs twice, and the least of both times counts; it takes the schemes Newmark and Static, and has a short
step in its reference. The spatula runs once and takes the steps of its reference, so its errors are those of the mesh.
Lines of single runs follow the table.
"""
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in ("tests/support", "drivers/plot")]
from driver_process import BENCH_ENVIRONMENT, STEPS, driver_command  # noqa: E402
from result_files import read_history  # noqa: E402

TOLERANCES = (0.01, 0.003, 0.001)
COMMON = ["Output/Fields Time Interval=0", "Output/Checkpoint/Keep=0"]
QUADRATIC = ["Mesh/Cell Order=2", "Interactions/Wall/Contact Element=Q2C2"]


class Strip:
    scene, column, window, repeats = "xml/strip.xml", "reaction_right_y", (20, 120), 2
    steps = {"Newmark": (1, 2, 4), "Static": (4, 8, 16)}
    reference = QUADRATIC + ["Mesh/Box/Divisions={400, 16}", "Time Integrator/Type=Newmark", STEPS + "Time Step=0.1"]

    @staticmethod
    def settings():
        """Yields name, settings and whether OLD serves them."""
        for mesh in ("80 x 4", "160 x 4", "160 x 8", "240 x 4", "240 x 6", "240 x 8", "320 x 4", "320 x 6", "320 x 8",
                     "320 x 16"):
            for contact, formulation in itertools.product(("Q1C1", "Q1C2", "Q1C4"), ("Standard", "Enhanced")):
                yield (f"{formulation}, {contact}, {mesh}",
                       ["Mesh/Box/Divisions={" + mesh.replace(" x", ",") + "}",
                        f"Interactions/Wall/Contact Element={contact}",
                        f"Materials/Strip/Element Formulation={formulation}"], True)
        for mesh in ("80 x 1", "80 x 2", "100 x 2", "120 x 2", "160 x 1", "160 x 2", "160 x 3", "180 x 3", "200 x 3",
                     "320 x 1", "320 x 2", "320 x 4"):
            yield f"quadratic, {mesh}", QUADRATIC + ["Mesh/Box/Divisions={" + mesh.replace(" x", ",") + "}"], False


class Spatula:
    scene, column, window, repeats = "xml/spatula-stiff.xml", "reaction_shaft end_z", (5, 40), 1
    steps = {"Gautam-Sauer Composite": (0.5,)}

    @staticmethod
    def thin(across, stations):
        """A mesh with one layer of cells in the core of a section and one ring around it."""
        values = {"Core Cells": across, "Core Layers": 1, "Rings": 1, "Tip Rows": across // 4, "Stations": stations}
        return [f"Mesh/Spatula/{name}={value}" for name, value in values.items()]

    @staticmethod
    def settings():
        """Yields name, settings and whether OLD serves them."""
        for (contact, formulation), cells in itertools.product(
                (("Q1C1", "Standard"), ("Q1C2", "Standard"), ("Q1C2", "Enhanced")), (1500, 5000, 14300, 40000)):
            yield (f"{formulation}, {contact}, {cells} cells",
                   [f"Mesh/Spatula/Target Cells={cells}", f"Interactions/Wall/Contact Element={contact}",
                    f"Materials/Keratin/Element Formulation={formulation}"], True)
        for across, stations in ((8, 90), (12, 90), (12, 120), (12, 150), (12, 180), (16, 200)):
            yield (f"Enhanced, Q1C2, {across} across, {stations} along", Spatula.thin(across, stations) + [
                "Interactions/Wall/Contact Element=Q1C2", "Materials/Keratin/Element Formulation=Enhanced"], True)


Spatula.reference = QUADRATIC + Spatula.thin(16, 200)


def run(problem, checkout, settings, folder):
    """Returns the time of a run and its processor time, or None if it does not complete."""
    end = f"{STEPS}Final Time={problem.window[1]}"
    scene = problem.scene
    if not os.path.exists(f"{checkout}/{scene}"):
        scene = "xml/spatula.xml"  # the same shape, before there were two
    command = driver_command(f"{checkout}/build/release/drivers/ixos", f"{checkout}/{scene}",
                             ["--overwrite", "--output", str(folder)], COMMON + [end] + settings, 1)
    times = []
    for _ in range(problem.repeats):
        begin = time.perf_counter()
        with subprocess.Popen(command, env=BENCH_ENVIRONMENT, stderr=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if status != 0:
            return None
        times.append((time.perf_counter() - begin, usage.ru_utime + usage.ru_stime))
    return tuple(min(column) for column in zip(*times))


def error(problem, folder, reference):
    """Returns the rms difference of the force from the reference's at the run's times, relative to its rms."""
    (times, values), (fine_times, fine) = (
        (history["time"], history[problem.column])
        for history in (read_history(pathlib.Path(path, "history.csv")) for path in (folder, reference)))
    if times[-1] < problem.window[1] or fine_times[-1] < problem.window[1]:
        return np.inf
    window = (times >= problem.window[0]) & (times <= problem.window[1])
    exact = np.interp(times[window], fine_times, fine)
    return np.sqrt(np.mean((values[window] - exact) ** 2) / np.mean(exact**2))


def measure(problem, checkout, settings, scheme, folder):
    """Yields step, both times and error, smaller steps first."""
    worst = 0
    for step in problem.steps[scheme]:
        stepping = [f"Time Integrator/Type={scheme}", f"{STEPS}Time Step={float(step)}"]
        seconds = run(problem, checkout, settings + stepping, f"{folder}/run")
        if seconds is None:
            return
        worst = max(worst, error(problem, f"{folder}/run", f"{folder}/reference"))
        yield step, seconds, worst


def main():
    if len(sys.argv) not in (5, 6) or sys.argv[1] not in ("strip", "spatula"):
        sys.exit(__doc__)
    problem, folder = {"strip": Strip, "spatula": Spatula}[sys.argv[1]], sys.argv[4]
    pattern = re.compile(sys.argv[5] if len(sys.argv) == 6 else "")
    checkouts = {"old": sys.argv[2], "new": sys.argv[3]}
    summary = pathlib.Path(folder, "reference/summary.json")
    whole = summary.exists() and json.loads(summary.read_text())["status"] == "completed"
    if not whole and run(problem, checkouts["new"], problem.reference, f"{folder}/reference") is None:
        sys.exit("the reference does not complete")
    if not any(pattern.search(name) for name, _, _ in problem.settings()):
        sys.exit(f"no setting's name has \"{pattern.pattern}\"")
    runs = []
    for scheme, (name, settings, both) in itertools.product(problem.steps, problem.settings()):
        if not pattern.search(name):
            continue
        for which in ("old", "new") if both else ("new",):
            runs += [(seconds, worst, which, scheme, f"{name}, dt = {step}") for step, seconds, worst in
                     measure(problem, checkouts[which], settings, scheme, folder)]
    print("| error | scheme | checkout | fastest settings | their error | s | processor, s |")
    print("|---|---|---|---|---|---|---|")
    for tolerance, scheme, which in itertools.product(TOLERANCES, problem.steps, checkouts):
        best = min((each for each in runs if each[1] <= tolerance and each[2:4] == (which, scheme)), default=None)
        if best:
            print(f"| {tolerance:.1%} | {scheme} | {which} | {best[4]} | {best[1]:.5f} | "
                  f"{best[0][0]:.3f} | {best[0][1]:.3f} |")
    for seconds, worst, which, scheme, name in sorted(runs):
        print(f"{which}: {seconds[0]:.3f} s, processor {seconds[1]:.3f} s, error {worst:.5f}: {scheme}, {name}")


if __name__ == "__main__":
    main()
