#!/usr/bin/python3
"""Runs xml/spring-block.xml at several speeds of the spring, and pushed without a spring.

It compares forces and ways with closed forms.

    docs/cookbook/spring-block/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as rigid  # noqa: E402

STEP = 0.01
PULL = "Histories/Pull/Expression/"


def pulled(speed, folder):
    """Pulls the block by the spring at a speed."""
    return recipe.run("spring-block", {**recipe.QUIET, PULL + "Value": f"{speed!r}*t", PULL + "Velocity": speed},
                      folder)


def pushed(speed, folder):
    """Pushes the block; the spring is too soft to matter."""
    return recipe.run("spring-block", {**recipe.QUIET, "Grips/Machine/Stiffness": [1e-9, 0.0],
                                       "Initial Conditions/Velocity": [speed, 0.0],
                                       recipe.STEPS + "Time Step": 0.1 * STEP,
                                       recipe.STEPS + "Final Time": round(0.3 * speed, 3)}, folder)


def spring_force(run, speed):
    """Returns times after the first slip, and the spring's force there."""
    later = run["time"] > rigid.first_slip(speed)
    time = run["time"][later]
    return time, rigid.SPRING * (speed * time - run["block_ux"][later])


def unbalanced(run):
    """Returns the largest change of energy that work and dissipation do not explain."""
    return np.abs(run.energy_error()).max()


def draw(pulls, pushes):
    """Draws the spring's force over time, and the way of the pushed block over its speed."""
    picture, (left, right) = recipe.figure(2)
    time = np.linspace(0, 4, 1000)
    for color, (speed, run) in zip(recipe.style.COLORS, pulls.items()):
        left.plot(run["time"], 1e3 * rigid.SPRING * (speed * run["time"] - run["block_ux"]), color=color,
                  label=f"V = {speed:g} m/s")
        left.plot(time, 1e3 * rigid.spring_force(time, speed), ":", color=recipe.style.INK)
    left.set(xlabel="time [ns]", ylabel="force of the spring per depth [2 mN/m]", ylim=(-5, 20))
    left.legend(title="closed form: dotted", loc="upper right")
    speeds = np.linspace(0, 2.1, 100)
    right.plot(speeds, [rigid.stop(speed) for speed in speeds], ":", color=recipe.style.INK, label="m v²/(2 F)")
    right.plot(list(pushes), [run["block_ux"].max() for run in pushes.values()], "o", markersize=4,
               color=recipe.style.COLORS[0], label="Ixos")
    right.set(xlabel="speed of the push [m/s]", ylabel="way of the block [nm]")
    right.legend()
    recipe.save(picture, "spring-block")


def main():
    folder = recipe.arguments(__doc__).results
    pulls, pushes, rows, stops = {}, {}, [], []
    for row in recipe.reference("spring-block"):
        speed = row["speed"]
        pulls[speed] = pulled(speed, folder / f"pull-{speed:g}")
        pushes[speed] = pushed(speed, folder / f"push-{speed:g}")
        _, force = spring_force(pulls[speed], speed)
        rows.append([f"{speed:g}", f"{row['largest']:.6f}", f"{force.max():.6f}",
                     recipe.deviation(force.max(), row["largest"]), f"{row['least']:.6f}", f"{force.min():.6f}",
                     f"{unbalanced(pulls[speed]):.0e}"])
        way = pushes[speed]["block_ux"].max()
        stops.append([f"{speed:g}", f"{row['stop']:.6f}", f"{way:.6f}", recipe.deviation(way, row["stop"])])
    recipe.table(["V [m/s]", "largest force, closed form", "Ixos", "difference", "least force, closed form", "Ixos",
                  "energy error"], rows)
    print()
    recipe.table(["v [m/s]", "way, closed form [nm]", "Ixos [nm]", "difference"], stops)
    draw(pulls, pushes)


if __name__ == "__main__":
    main()
