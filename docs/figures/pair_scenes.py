"""Scenes of two balls that touch, and of one ball of as many cells before a wall. All begin at rest."""
import sys

from .runs import FINAL_TIME, ROOT

sys.path.append(str(ROOT / "tests/robustness/extremes"))
from runs import EQUILIBRIUM, scene_text, steps  # noqa: E402  pylint: disable=wrong-import-position

DIAMETER = 20.0
GAP = 1.2 * EQUILIBRIUM  # at which the bodies begin
CUTOFF = 2.0
STEP = 1e-3  # T0


def shape(cells, height):
    """Returns the entries of a ball; cells: divisions of its core and rings; height: of its centre."""
    return {"Type": "Ball", "Ball/Diameter": DIAMETER, "Ball/Center": [0.0, 0.0, height],
            "Ball/Core Divisions": cells[0], "Ball/Rings": cells[1]}


def material(block):
    """Returns the entries of the material of a block."""
    return {f"Materials/{block}/Block": block, f"Materials/{block}/Poisson's Ratio": 0.2,
            f"Materials/{block}/Density": 5e-7}


def two_balls(cells):
    """Returns the entries of one ball above another. The upper one is the secondary one."""
    scene = {"Mesh/Type": "Parts", **material("upper_body"), **material("lower_body"),
             "Interactions/Pair/Side Set": "upper_surface", "Interactions/Pair/Primary Side Set": "lower_surface",
             "Interactions/Pair/Cutoff": CUTOFF}
    for name, height in ("upper", DIAMETER + GAP), ("lower", 0.0):
        scene.update({f"Mesh/Parts/{name}/{path}": value for path, value in shape(cells, height).items()})
    return scene


def one_ball(cells):
    """Returns the entries of a ball of about twice as many cells of the same shape, before a wall."""
    larger = [round(count * 2 ** (1 / 3)) for count in cells]
    return {**{f"Mesh/{path}": value for path, value in shape(larger, DIAMETER / 2 + GAP).items()},
            **material("body"), "Interactions/Wall/Side Set": "surface", "Interactions/Wall/Cutoff": CUTOFF,
            "Interactions/Wall/Normal": [0.0, 0.0, 1.0]}


SCENES = {"one ball before a wall": one_ball, "two balls": two_balls}


def body(context, name, cells, count):
    """Writes a scene of SCENES. Returns its path and the settings of so many steps."""
    text = scene_text({**SCENES[name](cells), **steps("Average Vector Field", STEP, 1),
                       "Time Integrator/Average Vector Field/Interaction Points": 8,
                       "Nonlinear Solver/Tolerance": 1e-9})
    path = context.folder / f"{name.replace(' ', '-')}.xml"
    path.write_text(text, encoding="utf-8")
    return str(path), [f"{FINAL_TIME}={count * STEP}"]
