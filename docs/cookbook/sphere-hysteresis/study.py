#!/usr/bin/python3
"""Runs xml/sphere-hysteresis.xml over speeds. Prints the tables of sphere-hysteresis.md and draws its picture.

    docs/cookbook/sphere-hysteresis/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import recipe  # noqa: E402

UNIT = np.pi * 1000 * recipe.WORK  # of forces: pi R W
BEGIN, DEPTH, START = 40.0, 4.5, 3.0  # time of the pull, way of the top, least gap over r_eq at the start
STEP, WAY = 0.02, 4.6  # way of the top in a step of the pull, and in all: to where it started
SLOW = next(row["pull_off"] for row in recipe.reference("jkr") if row["tabor"] == 3)


def pulled(speed):
    """Returns the changes of the scene for a speed of the pull."""
    path, since = "Histories/Press, Wait, Pull/Expression/", f"(t - {BEGIN!r})"
    grown = f"exp(-{speed / 0.1!r}*{since})"  # the speed is reached within about 0.3 nm
    press = "t < 20 ? {} : (t < 40 ? {} : {})"
    return {path + "Value": press.format("-2.25*(1 - cos(_pi*t/20))", "-4.5",
                                         f"-4.5 + {speed!r}*{since} - 0.1*(1 - {grown})"),
            path + "Velocity": press.format("-0.1125*_pi*sin(_pi*t/20)", "0", f"{speed!r}*(1 - {grown})"),
            path + "Acceleration": press.format("-0.005625*_pi^2*cos(_pi*t/20)", "0", f"{speed ** 2 / 0.1!r}*{grown}")}


def press(folder, step=0.4):
    """Presses the sphere onto the wall and waits. Returns the run, which pulls resume."""
    return recipe.run("sphere-hysteresis", {recipe.STEPS + "Final Time": BEGIN, recipe.STEPS + "Time Step": step,
                                            "Output/Fields Time Interval": 0}, folder)


def account(run, start):
    """Returns what left the balance in the jump, and in all other steps: the work less the changes of energy and less
    what is dissipated. start: energy at the beginning."""
    left = np.diff(run["external_work"] - (run["total_energy"] - start) - run["dissipated_energy"])
    return left.max(), left.sum() - left.max()


class Pull:
    """A pull that resumes a press: approach, force over pi R W, pull-off force, and the account of the whole loop."""

    def __init__(self, speed, pressed, folder, way=STEP):
        step = way / speed
        run = recipe.run("sphere-hysteresis", {
            **pulled(speed), recipe.STEPS + "Time Step": step,
            recipe.STEPS + "Final Time": BEGIN + round(WAY / way) * step, **recipe.QUIET}, folder, pressed.folder)
        since = run["time"] - BEGIN
        self.force = run["contact_force_y"] / UNIT
        self.approach = DEPTH - START - speed * since + 0.1 * (1 - np.exp(-speed / 0.1 * since))
        self.pull_off = -recipe.vertex(self.approach, self.force, int(self.force.argmin()))[1]
        start = pressed["total_energy"][0]
        self.jump, self.rest = account(run, start)
        self.work, self.dissipated = run["external_work"][-1], run["dissipated_energy"][-1]
        self.stored = run["total_energy"][-1] - start


def elastic(folder):
    """Returns the pull-off force of the sphere without the branch."""
    return -recipe.run("sphere-hysteresis", {
        "Materials/Sphere/Maxwell Branches/Relaxation Times": [], "Materials/Sphere/Maxwell Branches/Moduli": [],
        **recipe.QUIET}, folder)["contact_force_y"].min() / UNIT


def draw(pressed, pulls, known):
    """Draws the force over the approach for each speed, and the pull-off force over the speed."""
    picture, (left, right) = recipe.figure(2, 7.2, 3.3)
    approach = -START + 2.25 * (1 - np.cos(np.pi * np.minimum(pressed["time"], 20) / 20))
    left.plot(approach, pressed["contact_force_y"] / UNIT, "k", label="pressed")
    for speed, run in pulls.items():
        left.plot(run.approach, run.force, label=f"{speed:g} nm/$T_0$")
    left.set(xlabel="approach [nm]", ylabel="force / $\\pi R W$ [-]")
    left.legend(fontsize=7)
    right.plot([row["speed"] for row in known], [row["pull_off"] for row in known], "k--", label="half-space")
    right.plot(list(pulls), [run.pull_off for run in pulls.values()], "o", markersize=5, label="Ixos")
    right.axhline(SLOW, color="k", linestyle=":", label="elastic, Tabor number 3")
    right.set(xscale="log", xlabel="speed [nm/$T_0$]", ylabel="pull-off force / $\\pi R W$ [-]")
    right.legend(fontsize=7)
    recipe.save(picture, "sphere-hysteresis")


def main():
    results = recipe.arguments(__doc__).results
    known, pulls = recipe.reference("sphere-hysteresis"), {}
    print(f"without the branch: {elastic(results / 'elastic'):.4f}, reference {SLOW:.4f}\n")
    presses = [press(results / f"press-{step:g}", step) for step in (0.4, 0.2)]
    rows, accounts = [], []
    for row in known:
        speed = row["speed"]
        runs = [Pull(speed, pressed, results / f"{speed:g}-{way:g}", way)
                for pressed, way in zip(presses, (STEP, STEP / 2))]
        pulls[speed] = runs[1]
        rows.append([f"{speed:g}", f"{row['pull_off']:.4f}", *(f"{run.pull_off:.4f}" for run in runs),
                     recipe.deviation(runs[1].pull_off, row["pull_off"])])
        fine = runs[1]
        accounts.append([f"{speed:g}", *(f"{value:.1f}" for value in (
            fine.work, fine.dissipated, fine.stored, fine.jump, fine.rest, runs[0].rest))])
    recipe.table(["speed [nm/T0]", "reference", "steps of 0.02 nm", "0.01 nm", "difference (0.01 nm)"], rows)
    print()
    recipe.table(["speed [nm/T0]", "work of press and pull", "dissipated", "still stored", "jump off",
                  "rest of the pull", "rest, steps of 0.02 nm"], accounts)
    print()
    recipe.table(["steps of the press [T0]", "jump on", "rest of the press"], [
        [f"{step:g}", *(f"{value:.1f}" for value in account(run, run["total_energy"][0]))]
        for step, run in zip((0.4, 0.2), presses)])
    pressed = presses[1]
    draw(pressed, pulls, known)


if __name__ == "__main__":
    main()
