#!/usr/bin/python3
"""Runs xml/rate-peel.xml, peels at constant speeds and with elastic strips, and compares the forces with the limits.

    docs/cookbook/rate-peel/study.py [--results FOLDER]"""
import pathlib
import sys

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as formulas  # noqa: E402

LENGTH, END = 110, 75.0  # of the strip, and the last displacement of its pulled end in runs at constant speed [nm]
STEADY = 60.0, 73.0  # the force is steady while the displacement is in this interval [nm]
SPEEDS = 0.0001, 0.001, 0.01, 0.05, 0.2, 1.0, 10.0, 100.0
STRIP = "Materials/Strip/"


def constant_speed(speed, ratio=1.2):
    """Returns the settings of a run at a constant speed; the ratio of the gaps sets the steps."""
    pull = "Histories/Pull/Expression/"
    return {**recipe.QUIET, "Mesh/Box/Lengths": [LENGTH, 2], "Mesh/Box/Divisions": [2 * LENGTH, 4],
            "Output/Probes/end/Point": [LENGTH, recipe.EQUILIBRIUM_GAP + 1],
            pull + "Value": "t", pull + "Velocity": "1", pull + "Acceleration": "0", pull + "Value Unit": 1.0,
            pull + "Time Unit": 1 / speed, recipe.STEPS + "Final Time": END / speed,
            recipe.STEPS + "Time Step": 0.01 / speed, recipe.STEPS + "Adaptive/Maximum Gap Ratio": ratio}


def elastic(shear, ratio=1.2):
    """Returns the settings of a run without branches and with this shear modulus in their place."""
    return {**constant_speed(1.0, ratio), STRIP + "Maxwell Branches/Relaxation Times": [],
            STRIP + "Maxwell Branches/Moduli": [], STRIP + "Mooney-Rivlin/C10": shear / 2,
            STRIP + "Mooney-Rivlin/Poisson's Ratio": formulas.poisson(shear)}


def steady_force(run):
    """Returns the mean force of the steady part."""
    return run["reaction_end_y"][steady(run)].mean()


def steady(run):
    """Returns which rows belong to the steady part."""
    return (run["end_uy"] > STEADY[0]) & (run["end_uy"] < STEADY[1])


def balance(run):
    """Returns work, dissipated and stored energy of the steady part, each per length of strip that came off.

    That length follows from the energy of adhesion, and finer than from the points in contact."""
    def change(name):
        values = run[name][steady(run)]
        return values[-1] - values[0]
    length = change("contact_energy") / recipe.WORK
    return (change("external_work") / length, change("dissipated_viscoelasticity_of_body") / length,
            (change("elastic_energy") + change("kinetic_energy")) / length)


def draw(sweep, speeds, runs, limits):
    """Draws the steady and the largest force over the speed."""
    picture, (left, right) = recipe.figure(2)
    ink, colors = recipe.style.INK, recipe.style.COLORS
    rows = sweep["end_uy"] > 30
    left.plot(sweep["end_vy"][rows], sweep["reaction_end_y"][rows] / recipe.WORK, color=colors[0],
              label="scene: the speed rises")
    left.plot(speeds, [steady_force(run) / recipe.WORK for run in runs], "o", markersize=4, color=colors[1],
              label="constant speed")
    left.axhline(limits[0]["steady"] / recipe.WORK, color=ink, linestyle=":", label="elastic")
    left.plot(fast := [5 * 1.2**i for i in range(17)], [formulas.fast(v) / recipe.WORK for v in fast], "--", color=ink,
              label="closed form, high speed")
    left.set(xlabel="speed [nm/µs]", ylabel="steady force per width / W", xscale="log", ylim=(0.97, 1.8))
    left.legend(loc="upper left")
    right.plot(speeds, [run["reaction_end_y"].max() for run in runs], "o", markersize=4, color=colors[1],
               label="constant speed")
    for limit, line, label in zip(limits, (":", "--"), ("after a long time", "instantaneous")):
        right.axhline(limit["largest"], color=ink, linestyle=line, label="elastic, " + label)
    right.set(xlabel="speed [nm/µs]", ylabel="largest force per width [2 N/m]", xscale="log", ylim=(0.066, 0.09))
    right.legend(loc="upper left")
    recipe.save(picture, "rate-peel")


def main():
    folder = recipe.arguments(__doc__).results
    expected = {row["speed"]: row["force"] for row in recipe.reference("rate-peel")}
    limits, rows = [], []
    for name, speed, shear in (("long", 0, formulas.SHEAR), ("instantaneous", float("inf"),
                                                             formulas.SHEAR + formulas.BRANCH)):
        run = recipe.run("rate-peel", elastic(shear), folder / name)
        limits.append({"steady": steady_force(run), "largest": run["reaction_end_y"].max()})
        rows.append([f"elastic, mu = {shear:g}", f"{steady_force(run):.5f}", f"{expected[speed]:.5f}",
                     recipe.deviation(steady_force(run), expected[speed]), f"{limits[-1]['largest']:.4f}"])
    runs = [recipe.run("rate-peel", constant_speed(speed), folder / f"{speed:g}") for speed in SPEEDS]
    for speed, run in zip(SPEEDS, runs):
        formula = expected.get(speed)
        rows.append([f"{speed:g}", f"{steady_force(run):.5f}", f"{formula:.5f}" if formula else "",
                     recipe.deviation(steady_force(run), formula) if formula else "",
                     f"{run['reaction_end_y'].max():.4f}"])
    recipe.table(["speed", "Ixos", "closed form", "difference", "largest force"], rows)
    print()
    rows = []
    for speed, run in zip(SPEEDS, runs):
        work, dissipated, stored = balance(run)
        rows.append([f"{speed:g}", f"{work:.6f}", f"{recipe.WORK:.6f}", f"{dissipated:.6f}", f"{stored:.6f}",
                     f"{abs(work - recipe.WORK - dissipated - stored):.0e}", f"{run.energy_error().max():.0e}"])
    recipe.table(["speed", "work", "adhesion, W", "dissipated", "stored", "difference", "largest error of the run"],
                 rows)
    sweep = recipe.run("rate-peel", recipe.QUIET, folder / "scene")
    largest = sweep["reaction_end_y"][sweep["end_uy"] > 30].argmax() + (sweep["end_uy"] <= 30).sum()
    print(f"\nscene: largest force {sweep['reaction_end_y'][largest]:.5f} at the speed {sweep['end_vy'][largest]:.2g}, "
          f"at the end {sweep['reaction_end_y'][-1]:.5f}; dissipated "
          f"{sweep['dissipated_viscoelasticity_of_body'][-1]:.4f} of the work {sweep['external_work'][-1]:.4f}, "
          f"error of the balance {sweep.energy_error().max():.0e}")
    draw(sweep, SPEEDS, runs, limits)


if __name__ == "__main__":
    main()
