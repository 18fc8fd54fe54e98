#!/usr/bin/python3
"""Compares the errors that ixos --accuracy reports with those against much finer fixed steps, and its cost with that of
its last run alone (about 6 minutes). Prints a table in Markdown.

    IXOS_DRIVER=build/release/drivers/ixos tests/bench/accuracy.py [NAME]

NAME takes the cases whose names have it in them. The exact values of the oscillator are known in closed form.
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
NO_FRAMES = ["Output/Fields Interval=0", "Output/Fields Time Interval=0", "Output/Checkpoint/Keep=0"]
BALL = [STEPS + "Final Time=2"]
STRIP = [STEPS + "Final Time=20", "Histories/Pull/Rate Ramp/Length=10", "Mesh/Box/Divisions={160, 8}"]
WAVES = [STEPS + "Final Time=3", "Histories/Pull/Rate Ramp/Length=2"]
OSCILLATOR = {"final P_ux": 0.1 / math.sqrt(3) * math.sin(5 * math.sqrt(3)), "peak P_ux": 0.1 / math.sqrt(3),
              "time of P_ux below 0": math.pi / math.sqrt(3)}


def restitution(history):
    """Returns the ratio of the momentum's peaks after and before its first change of sign."""
    momentum = history["linear_momentum_y"]
    first = int(np.argmax(momentum > 0))
    after = momentum[first:]
    end = int(np.argmax(after < 0)) if (after < 0).any() else len(after)
    return np.abs(after[:end]).max() / np.abs(momentum[:first]).max()


def peak(history):
    return np.nanmax(np.abs(history["reaction_right_y"]))


def work(history):
    return history["external_work"][-1]


# By case: scene, settings, accuracies, fixed step of the finer run and its quantities, or exact values.
CASES = {
    "oscillator": ("tests/verification/oscillator.xml", [], ("1%", "0.01%"), None, OSCILLATOR),
    "short strip": ("xml/strip.xml", STRIP, ("1%", "0.1%", "0.01%"), 0.0025,
                    {"peak reaction_right_y": peak, "work": work}),
    "first waves in the strip": ("xml/strip.xml", WAVES, ("1%", "0.1%"), 0.005,
                                 {"peak contact_force_y": lambda history: np.abs(history["contact_force_y"]).max()}),
    "strip": ("xml/strip.xml", [STEPS + "Final Time=60"], ("1%", "0.1%"), 0.02, {"peak reaction_right_y [20, 60]": peak}),
    "ball": ("xml/ball.xml", BALL, ("3%", "1%", "0.1%"), 1e-5, {"restitution linear_momentum_y": restitution}),
    "ball, Bathe Composite": ("xml/ball.xml", BALL + ["Time Integrator/Type=Bathe Composite"], ("1%",), 1e-5,
                              {"restitution linear_momentum_y": restitution}),
}


def run(scene, folder, settings, *options):
    """Runs a scene and returns its summary; the exit status may tell of an accuracy that is not reached."""
    command = driver_command(DRIVER, str(ROOT / scene), ["--overwrite", "--output", folder, *options],
                             settings + NO_FRAMES, 1)
    subprocess.run(command, env=ENVIRONMENT, check=False, stderr=subprocess.DEVNULL)
    return read_summary(pathlib.Path(folder, "summary.json"))


def main():
    part = sys.argv[1] if len(sys.argv) > 1 else ""
    print("| case | asked | quantity | reported error | error | runs | steps of the last | of all, relative "
          "| seconds of all, relative |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, (scene, settings, accuracies, step, quantities) in CASES.items():
        if part not in name:
            continue
        with tempfile.TemporaryDirectory(prefix="ixos-accuracy-") as folder:
            exact = quantities
            if step is not None:
                run(scene, folder + "/fine", settings + [f"{STEPS}Time Step={step}"])
                history = read_history(pathlib.Path(folder, "fine/history.csv"))
                exact = {text: value(history) for text, value in quantities.items()}
            named = settings + ["Output/Quantities={" + ", ".join(quantities) + "}"]
            for accuracy in accuracies:
                summary = run(scene, folder + "/out", named, "--accuracy", accuracy)
                found = summary["accuracy"]
                costs = [sum(each[cost] for each in found["runs"]) / found["runs"][-1][cost]
                         for cost in ("steps", "seconds")]
                for own in found["quantities"]:
                    error = abs(own["value"] / exact[own["quantity"]] - 1)
                    reported = "unknown" if own["error"] is None else f"{100 * own['error']:.2g} %"
                    asked = accuracy if found["kept"] else accuracy + ", not kept"
                    print(f"| {name} | {asked} | {own['quantity']} | {reported} | {100 * error:.2g} % "
                          f"| {len(found['runs'])} | {summary['steps']} | {costs[0]:.2f} | {costs[1]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
