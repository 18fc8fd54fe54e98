#!/usr/bin/python3
"""Runs xml/probe.xml, on approach with two ranges of the attraction, and compares it with a measurement and with JKR.

    docs/cookbook/probe/study.py [--results FOLDER]"""
import math
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as jkr  # noqa: E402

GAP = 0.06  # without traction, of the scene [um]
START = 0.5  # of the sphere above that gap
TURN = 50  # time at which the base turns
WORKS = {"in": 0.0365, "out": 0.056}  # of approach and retraction [N/m]
SPHERE = "Interactions/Sphere/"


def measured():
    """Returns the three measured values of each quantity."""
    return {row["quantity"]: [row[f"curve {k}"] for k in (2, 3, 4)] for row in recipe.reference("probe")}


def probe(folder, settings=None):
    """Runs the scene."""
    return recipe.run("probe", {**recipe.QUIET, **(settings or {})}, folder)


def approach(folder):
    """Runs the approach alone, with half the range of the attraction and half the size of the cells."""
    centre = [0, START + GAP / 2 + jkr.RADIUS]
    return probe(folder, {"Mesh/Refine/Contact/Levels": 5, "Rigid Bodies/Probe/Centre": centre,
                          SPHERE + "Sphere/Center": centre, SPHERE + "Strength": 1.2488,
                          "Stages/Retraction/Time Integrator/Time Step Control/Final Time": TURN + 0.5})


def depth(run):
    """Returns how far the base is below the place where the sphere touches."""
    return -START - 0.03 * (np.sqrt((run["time"] - TURN)**2 + 1) - math.sqrt(TURN**2 + 1))


def force(run):
    """Returns the force of the spring on the probe, positive for pressure."""
    return jkr.STIFFNESS * (run["Probe_uy"] + START + depth(run))


def loading(run):
    """Returns what the measurement has of an approach."""
    base, spring = depth(run), force(run)
    down = np.flatnonzero((run["time"] < TURN) & (base > -0.1))
    pressed = down[base[down] > 0.1]
    return {"force_in": float(np.interp(np.mean(measured()["depth_in"]), base[down], spring[down])),
            "zero_loading": float(np.interp(0, spring[pressed], base[pressed]))}


def release(run):
    """Returns the first row in which the probe has come off."""
    off = np.flatnonzero((run["time"] > TURN) & (run["min_gap"] > 2 * GAP))
    if not off.size:
        raise RuntimeError("the probe does not come off")
    return off[0]


def unloading(run):
    """Returns what it has of a retraction."""
    base, spring, out = depth(run), force(run), release(run)
    held = np.arange(np.argmax(run["time"] > TURN), out)
    pressed = held[base[held] > 0.1][::-1]
    return {"zero_unloading": float(np.interp(0, spring[pressed], base[pressed])),
            "pull": float(spring[held].min()), "height_out": -float(base[out]), "force_out": float(spring[out - 1])}


def ring(run):
    """Returns the period in which the probe rings after it has come off, by the zeros of its velocity."""
    free = np.flatnonzero((run["time"] > TURN) & (run["min_gap"] > 0.2) & (run["time"] < 120))
    time, velocity = run["time"][free], run["Probe_vy"][free] - 0.03
    turns = np.flatnonzero(velocity[:-1] * velocity[1:] < 0)
    zeros = time[turns] - velocity[turns] * (time[turns + 1] - time[turns]) / (velocity[turns + 1] - velocity[turns])
    return 2 * float(np.mean(np.diff(zeros[1:9])))


def closed_forms():
    """Returns the same numbers by JKR, without the range of the attraction."""
    height, last = jkr.release(WORKS["out"])
    return {"force_in": jkr.at_depth(WORKS["in"], float(np.mean(measured()["depth_in"]))),
            "zero_loading": jkr.zero(WORKS["in"]), "zero_unloading": jkr.zero(WORKS["out"]),
            "pull": jkr.pull(WORKS["out"]), "height_out": height, "force_out": last}


NAMES = {"force_in": "force after the jump-in [uN]", "zero_loading": "depth without force, loading [um] (fitted)",
         "zero_unloading": "depth without force, unloading [um]", "pull": "largest pull [uN] (fitted)",
         "height_out": "height at the jump-out [um]", "force_out": "force before it [uN]"}


def draw(run):
    """Draws the force over the depth of the base, and the ringing after both jumps."""
    picture, (left, right) = recipe.figure(2)
    base, spring, down = depth(run), force(run), run["time"] < TURN
    for work, color in ((WORKS["in"], 0), (WORKS["out"], 1)):
        x, y = jkr.depths(work, jkr.stable(work, 3.2))
        left.plot(x, y, ":", color=recipe.style.INK, label="JKR" if color == 0 else None)
    for part, color, label in ((down, 0, "approach"), (~down, 1, "retraction")):
        left.plot(base[part], spring[part], color=recipe.style.COLORS[color], label=label)
    at = {name: np.mean(values) for name, values in measured().items()}
    left.plot([at["depth_in"], at["zero_loading"], at["zero_unloading"], -at["height_out"]],
              [at["force_in"], 0, 0, at["force_out"]], "o", color=recipe.style.INK, markersize=4, label="measured")
    left.axhline(at["pull"], color=recipe.style.INK, linewidth=0.6)
    left.set(xlabel="depth of the base [um]", ylabel="force of the spring [uN]", xlim=(-1.15, 1.0), ylim=(-2.4, 1.6))
    left.legend(loc="upper left", fontsize=7)
    jumps = {"in": run["time"][int((run["min_gap"] < 1.5 * GAP).argmax())], "out": run["time"][release(run)]}
    for name, color in (("in", 0), ("out", 1)):
        near = abs(run["time"] - jumps[name] - 2) < 2.5
        right.plot(run["time"][near] - jumps[name], spring[near], color=recipe.style.COLORS[color],
                   label="jump-" + name)
    right.set(xlabel="time from the jump [ms]", ylabel="force of the spring [uN]", xlim=(-0.5, 4.5))
    right.legend(loc="upper right", fontsize=7)
    recipe.save(picture, "probe")


def main():
    folder = recipe.arguments(__doc__).results
    run, finer = probe(folder / "run"), loading(approach(folder / "approach"))
    found, exact, at = {**loading(run), **unloading(run)}, closed_forms(), measured()
    rows = []
    for name, words in NAMES.items():
        half = finer.get(name)
        best = 2 * half - found[name] if half else found[name]
        rows.append([words, f"{min(at[name]):.3f} to {max(at[name]):.3f}", f"{found[name]:.3f}",
                     f"{half:.3f}" if half else "", f"{best:.3f}" if half else "",
                     recipe.deviation(best, float(np.mean(at[name]))), f"{exact[name]:.3f}"])
    recipe.table(["", "measured", f"gap {1000 * GAP:g} nm", f"{500 * GAP:g} nm", "extrapolated", "difference", "JKR"],
                 rows)
    print(f"\nperiod of the free probe: {ring(run):.4f} ms, closed form {jkr.ring():.4f} ms")
    draw(run)


if __name__ == "__main__":
    main()
