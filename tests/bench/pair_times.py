#!/usr/bin/python3
"""Times increments of two balls that touch, and of one ball of as many cells before a wall, one after the other.

    tests/bench/pair_times.py [--driver build/release/drivers/ixos] [--cells 16,10] [--steps 6] [--ranks 1]

The balls have --cells core divisions and rings; the one ball has about twice as many cells. All begin at rest, a gap
1.2 times that of equilibrium apart. The table has the seconds, the Newton iterations and the phases of an increment,
and the ratio of two balls to one."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "robustness/extremes"))
from runs import ENVIRONMENT, EQUILIBRIUM, ROOT, scene_text, steps, table  # noqa: E402

DIAMETER = 20.0


def shape(divisions, rings, height):
    return {"Type": "Ball", "Ball/Diameter": DIAMETER, "Ball/Center": [0.0, 0.0, height],
            "Ball/Core Divisions": divisions, "Ball/Rings": rings}


def material(block):
    return {f"Materials/{block}/Block": block, f"Materials/{block}/Poisson's Ratio": 0.2,
            f"Materials/{block}/Density": 5e-7}


def two_balls(divisions, rings):
    """The upper ball is the secondary one."""
    scene = {"Mesh/Type": "Parts", **material("upper_body"), **material("lower_body"),
             "Interactions/Pair/Side Set": "upper_surface", "Interactions/Pair/Primary Side Set": "lower_surface",
             "Interactions/Pair/Cutoff": 2.0}
    for name, height in ("upper", DIAMETER + 1.2 * EQUILIBRIUM), ("lower", 0.0):
        scene.update({f"Mesh/Parts/{name}/{path}": value for path, value in shape(divisions, rings, height).items()})
    return scene


def one_ball(divisions, rings):
    """A ball of about twice as many cells of the same shape."""
    larger = round(divisions * 2 ** (1 / 3)), round(rings * 2 ** (1 / 3))
    return {**{f"Mesh/{path}": value for path, value in shape(*larger, DIAMETER / 2 + 1.2 * EQUILIBRIUM).items()},
            **material("body"), "Interactions/Wall/Side Set": "surface", "Interactions/Wall/Cutoff": 2.0,
            "Interactions/Wall/Normal": [0.0, 0.0, 1.0]}


def run(scene, options, folder):
    file = pathlib.Path(folder, "scene.xml")
    file.write_text(scene_text({**scene, **steps("Average Vector Field", 1e-3, options.steps),
                                "Time Integrator/Average Vector Field/Interaction Points": 8,
                                "Nonlinear Solver/Tolerance": 1e-9}))
    command = ["mpirun", "-np", str(options.ranks)] if options.ranks > 1 else []
    subprocess.run([*command, options.driver, str(file), "--output", folder + "/results", "--overwrite", "--quiet"],
                   env=ENVIRONMENT, check=True)
    return json.loads(pathlib.Path(folder, "results/summary.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--driver", default=str(ROOT / "build/release/drivers/ixos"))
    parser.add_argument("--cells", default="16,10")
    parser.add_argument("--steps", type=int, default=6)
    parser.add_argument("--ranks", type=int, default=1)
    options = parser.parse_args()
    divisions, rings = map(int, options.cells.split(","))
    rows, times = [], []
    for name, scene in ("two balls", two_balls(divisions, rings)), ("one ball before a wall", one_ball(divisions, rings)):
        with tempfile.TemporaryDirectory() as folder:
            summary = run(scene, options, folder)
        count = summary["steps"]
        times.append(summary["wall_seconds"] / count)
        phases = [f"{summary['seconds'].get(phase, 0) / count:.3f}" for phase in ("residual", "tangent", "linear solve")]
        rows.append([name, str(summary["elements"]), str(summary["dofs"]), f"{times[-1]:.3f}",
                     f"{summary['newton_iterations'] / count:.1f}", *phases])
    print("\n".join(table(["bodies", "cells", "degrees of freedom", "s an increment", "Newton/increment", "residual",
                           "tangent", "linear solve"], rows)))
    print(f"ratio: {times[0] / times[1]:.2f}")


if __name__ == "__main__":
    main()
