#!/usr/bin/python3
"""Runs xml/pillar-backing.xml with pillars of several heights: compliance, and the pull-off force, which is that without a backing.

    docs/cookbook/pillar-backing/study.py [--results FOLDER]"""
import pathlib
import sys

import numpy as np

sys.path[:0] = [str(folder) for folder in pathlib.Path(__file__).resolve().parents[:2]]
import recipe  # noqa: E402
import reference as series  # noqa: E402

FULL_FORCE = 3856  # pull-off force without a backing, Dugdale's model (docs/cookbook/pillar/reference.csv)
DIVISIONS = 30  # of the pillar's height


def settings(height, steps=100, end=None, divisions=DIVISIONS, backing=50, matching=False,
             defect=True):
    """Returns the settings of a run with a pillar of this height, to 20 per cent beyond pull-off.

    divisions: of the pillar's height; backing: of the backing's sides; matching: the backing has the pillar's radial
    cells, and as many again beyond."""
    end = end or round(1.2 * FULL_FORCE * (series.bar(height) + series.half_space()), 1)
    choice = {"Mesh/Parts/backing/Box/Divisions": [backing, backing]}
    if not defect:
        choice["Interactions/Adhesion/Factor"] = "1"
    if matching:
        choice |= {"Mesh/Parts/backing/Box/Lower": [-1, 0], "Mesh/Parts/backing/Box/Lengths": [3, 1],
                   "Mesh/Parts/backing/Box/Divisions": [3 * divisions, backing],
                   "Mesh/Parts/backing/Map/X": "x < 1 ? 40 + 30*x + (x < 0 ? 10 : 230)*x^3"
                                               " : 300 + 720*(x - 1) + 4980*(x - 1)^3"}
    return {"Mesh/Parts/pillar/Map/Y": f"0.0002 + 30*y + {height - 30}*y^2*(3 - 2*y)",
            "Mesh/Parts/pillar/Box/Divisions": [2 * divisions, divisions],
            "Mesh/Parts/backing/Map/Y": f"{height}.0002 + 700*y + 5300*y^3", **choice,
            recipe.STEPS + "Final Time": end, recipe.STEPS + "Time Step": end / steps, **recipe.QUIET}


def compliance(run):
    """Returns displacement over force of the increment from the first to the sixth step."""
    force = run["reaction_backing_top_y"]
    return (run["time"][6] - run["time"][1]) / (force[6] - force[1])


def pull_off(run):
    """Returns the largest force."""
    return np.nanmax(run["reaction_backing_top_y"])


def small(height, folder, **given):
    """Returns the compliance of a run to a small displacement, in 1e-6 of the scene's units."""
    return 1e6 * compliance(recipe.run("pillar-backing", settings(height, steps=8, end=0.8, defect=False, **given),
                                       folder))


def draw(runs, compliances):
    """Draws the force over the displacement, and the compliance over the pillar's height."""
    picture, (left, right) = recipe.figure(2)
    for color, (height, run) in zip(recipe.style.COLORS, runs.items()):
        left.plot(run["time"][1:], run["reaction_backing_top_y"][1:], color=color, label=f"{height:g} nm")
    left.set(xlabel="displacement of the backing's top [nm]", ylabel="force [2 nN]")
    left.legend(fontsize=7)
    heights = np.linspace(0, 2500, 50)
    right.plot(heights, 1e3 * series.bar(heights), ":", color=recipe.style.INK, label="pillar alone")
    right.plot(heights, 1e3 * (series.bar(heights) + series.half_space()), "-", color=recipe.style.INK, label="bound")
    right.plot(list(compliances), [1e-3 * value for value in compliances.values()], "o", markersize=4,
               color=recipe.style.COLORS[0], label="Ixos")
    right.set(xlabel="height of the pillar [nm]", ylabel="displacement / force [nm / 2 uN]")
    right.legend(fontsize=7)
    recipe.save(picture, "pillar-backing")


def main():
    folder = recipe.arguments(__doc__).results
    rows, runs, compliances = [], {}, {}
    for row in recipe.reference("pillar-backing"):
        height = int(row["height"])
        runs[height] = recipe.run("pillar-backing", settings(height, steps=200), folder / str(height))
        found = compliances[height] = small(height, folder / f"{height}-small")
        matching = small(height, folder / f"{height}-matching", matching=True)
        force = pull_off(runs[height])
        rows.append([height, f"{row['bar']:.0f}", f"{row['bound']:.0f}", f"{found:.0f}", f"{found - row['bar']:.0f}",
                     recipe.deviation(found, matching), f"{force:.0f}", recipe.deviation(force, FULL_FORCE)])
    recipe.table(["height [nm]", "pillar alone", "bound", "Ixos", "Ixos less the pillar alone",
                  "difference to matching meshes", "pull-off force", "difference to Dugdale"], rows)
    draw(runs, compliances)


if __name__ == "__main__":
    main()
