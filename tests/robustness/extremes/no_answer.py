"""Scenes without an answer: no equilibrium, no support, conditions that contradict each other, steps beyond reason.

None may end with status 0 and no warning. `expected` is the outcome (see runs.Outcome; "warned" is a completed run with
a warning) and a part of the message.
"""
from pairs import bodies
from runs import EQUILIBRIUM, box, held, ramp, steps, wall

STRENGTH = 0.0624428  # largest attraction of the default law [E0]


def block(height=EQUILIBRIUM):
    return box((4, 2), (4, 2), (0, height))


def static(count=20):
    return steps("Static", 1 / count, count)


def load(kind, vector, **where):
    """A load that grows from 0 to that vector at the time 1."""
    path = "Boundary Conditions/Load/"
    return {path + "Type": kind, path + "Vector": vector, path + "History": "Load", **ramp("Load", 1.0),
            **{path + name.replace("_", " "): value for name, value in where.items()}}


def guided(name="left"):
    return held("Guide", name, "x")


def pulled(**law):
    return {**block(), **wall(**law), **guided(), **load("Traction", [0.0, 2 * STRENGTH], Side_Set="top"), **static()}


def solid(traction):
    return {**box((2, 2, 1), (2, 2, 1), (0, 0, EQUILIBRIUM)), **wall(), **guided(), **held("Side", "front", "y"),
            **load("Traction", [0.0, 0.0, traction], Side_Set="top"), **static()}


def revolved():
    return {**block(), "Mesh/Geometry": "Axisymmetric", **wall(), **static(),
            **load("Traction", [0.0, 2 * STRENGTH], Side_Set="top")}


def pair(gap, lower_held=True, height=1):
    """Two bodies of 4 by `height`, the upper one above the lower one's top at y = 0."""
    parts = {name: {path[len("Mesh/"):]: value for path, value in box((4, height), (4, height), (0, bottom)).items()
                    if path.startswith("Mesh/")} for name, bottom in (("upper", gap), ("lower", -height))}
    return {**bodies(parts, "upper_bottom", "lower_top"), "Interactions/Pair/Smoothing": "None",
            **(held("Floor", "lower_bottom", "xy") if lower_held else {})}


def driven(motion, components="y", node_set="top"):
    return {**block(), **wall(), **held("Grip", node_set, components, "Way"), **ramp("Way", motion)}


NO_EQUILIBRIUM = "no equilibrium found beyond a load of"
UNHELD = "nothing holds"
FRICTION = {"Interactions/Wall/Friction/Type": "Constant Stress", "Interactions/Wall/Friction/Stress": 0.02}
PENALTY = {"Law": "Penalty"}

SCENES = {
    # No equilibrium.
    "traction beyond the strength": (pulled(), "failed", NO_EQUILIBRIUM),
    "traction beyond Morse's strength": (pulled(Law="Morse"), "failed", NO_EQUILIBRIUM),
    "traction beyond a law that ends": (pulled(Cutoff=2.0), "failed", NO_EQUILIBRIUM),
    "traction beyond a smooth plateau": (pulled(Law="Smooth Dugdale"), "failed", NO_EQUILIBRIUM),
    "traction beyond a bond": (pulled(Law="Bilinear Damage"), "failed", NO_EQUILIBRIUM),
    "traction away from a penalty": (pulled(Law="Penalty"), "failed", NO_EQUILIBRIUM),
    "traction in space": (solid(2 * STRENGTH), "failed", NO_EQUILIBRIUM),
    "traction on a body of revolution": (revolved(), "failed", NO_EQUILIBRIUM),
    "traction on one of two bodies": (
        {**pair(EQUILIBRIUM), **held("Guide", "upper_left", "x"), **static(),
         **load("Traction", [0.0, 2 * STRENGTH], Side_Set="upper_top")}, "failed", NO_EQUILIBRIUM),
    "weight on a ceiling": (
        {**block(), **wall(), **guided(), **static(), "Materials/Body/Density": 1.0,
         **load("Gravity", [0.0, STRENGTH])}, "failed", NO_EQUILIBRIUM),
    "force on nodes": ({**block(), **wall(), **guided(), **static(), **load("Point Force", [0.0, 0.1], Node_Set="top")},
                       "failed", NO_EQUILIBRIUM),
    "force per volume": ({**block(), **wall(), **guided(), **static(), **load("Body Force", [0.0, STRENGTH])}, "failed",
                         NO_EQUILIBRIUM),
    "a push beyond the friction": ({**block(), **wall(), **FRICTION, **static(),
                                    **load("Traction", [0.04, 0.0], Side_Set="bottom")}, "failed", NO_EQUILIBRIUM),
    "a pull off a sphere": (
        {**block(), **wall(Obstacle="Sphere"), "Interactions/Wall/Sphere/Radius": 20.0, **guided(),
         "Interactions/Wall/Sphere/Center": [2.0, -20.0], **load("Traction", [0.0, 2 * STRENGTH], Side_Set="top"),
         **static()}, "failed", NO_EQUILIBRIUM),
    # No support.
    "a load on a free body": ({**block(), **static(), **load("Traction", [0.0, 0.01], Side_Set="top")}, "failed", UNHELD),
    "a body held along x only": ({**block(), **static(), **guided(), **load("Traction", [0.0, 0.01], Side_Set="top")},
                                 "failed", UNHELD),
    "a push along a wall without friction": (
        {**block(), **wall(), **static(), **load("Traction", [0.01, 0.0], Side_Set="top")}, "failed", UNHELD),
    "a free body without a load": ({**block(), **static()}, "warned", UNHELD),
    "two bodies and one support": (
        {**pair(EQUILIBRIUM, lower_held=False), **static(), **held("Guide", "upper_left", "x"),
         **load("Traction", [0.0, 0.01], Side_Set="upper_top")}, "failed", UNHELD),
    # Conditions that contradict each other.
    "two motions of one node": ({**driven(1.0), **held("Other", "top", "y"), **static()}, "refused", "different motions"),
    "a grip that is driven through the wall": ({**driven(-1.0, node_set="bottom"), **guided(), **static()}, "failed",
                                                   "no equilibrium found beyond t"),
    "a body that is turned inside out": (
        {**block(), **held("Floor", "bottom", "xy"), **held("Grip", "top", "y", "Way"), **ramp("Way", -3.0), **static()},
        "failed", "no equilibrium found beyond t"),
    "a start in the wall": ({**block(-0.5), **wall(), **steps("Newmark", 1e-3, 10)}, "refused", "gap"),
    "a start in another body": ({**pair(-0.2), **steps("Newmark", 1e-3, 10)}, "refused", "gap"),
    # Steps beyond reason.
    "an impact in one step": ({**block(20.0), **wall(), "Initial Conditions/Velocity": [0.0, -100.0],
                               **steps("Newmark", 0.1, 10)}, "warned", "impacts are not resolved"),
    "an impact on a penalty in one step": (
        {**block(1.0), **wall(Obstacle="Sphere", **PENALTY), "Interactions/Wall/Sphere/Radius": 0.3,
         "Interactions/Wall/Sphere/Center": [2.0, 0.0], "Initial Conditions/Velocity": [0.0, -100.0],
         **steps("Average Vector Field", 0.05, 2)}, "failed", "passes"),
    "steps of a thousand waves": ({**block(), **wall(), **held("Grip", "top", "y", "Way"), **ramp("Way", 1e-3),
                                   **steps("Newmark", 10.0, 10)}, "warned", "wave"),
    "a branch that relaxes within a step": (
        {**block(), **held("Floor", "bottom", "xy"), **held("Grip", "top", "y", "Way"), "Histories/Way/Type": "Ramp",
         "Histories/Way/Ramp/Value": 0.1, "Histories/Way/Ramp/Length": 0.05, "Histories/Way/Ramp/Shape": "Linear",
         "Materials/Body/Maxwell Branches/Moduli": [40.0], "Materials/Body/Maxwell Branches/Relaxation Times": [0.05],
         **static()}, "warned", "relaxation"),
    "a motion that begins with a jump": (
        {**block(), **wall(), **held("Grip", "top", "y", "Way"), "Histories/Way/Type": "Constant",
         "Histories/Way/Constant/Value": 0.5, **steps("Newmark", 1e-3, 10)}, "warned", "jump"),
    "a bond that begins out of its range": (
        {**block(1.0), **wall(Law="Bilinear Damage"), "Initial Conditions/Velocity": [0.0, -5.0],
         **steps("Average Vector Field", 5e-4, 1000)}, "warned", "bond"),
    "a body that locks": (
        {**block(), "Materials/Body/Poisson's Ratio": 0.4995, **held("Floor", "bottom", "xy"), **static(),
         **load("Traction", [0.0, -0.05], Side_Set="top")}, "warned", "Mean Dilatation"),
}
