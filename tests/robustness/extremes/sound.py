"""Forty scenes in which nothing is wrong: they complete without a warning."""
from no_answer import block, guided, pair, solid, static
from runs import ELEMENTS, EQUILIBRIUM, SCHEMES, box, element, held, ramp, steps, wall

REPELLING = ["Van der Waals", "Morse", "Mie", "Xu-Needleman", "Bilinear Damage", "Penalty", "Log Barrier"]
SHORT = 2e-4, 200  # steps of a scheme: a tenth of the time in which a wave crosses the block


def moving(scheme="Average Vector Field", dimension=2):
    return {"Initial Conditions/Velocity": [0.0] * (dimension - 1) + [-0.5], **steps(scheme, *SHORT)}


def lifted(motion=0.1):
    """A grip that lifts the top slowly and a little, in 20 load steps."""
    return {**held("Grip", "top", "y", "Way"), **ramp("Way", motion), **guided(), **static()}


def brick():
    return box((4, 2, 2), (4, 2, 2), (0, 0, EQUILIBRIUM))


def round_wall(name, **numbers):
    return {**wall(Obstacle=name), **{f"Interactions/Wall/{name}/{entry}": value for entry, value in numbers.items()}}


def branch(time):
    return {"Materials/Body/Maxwell Branches/Moduli": [0.2], "Materials/Body/Maxwell Branches/Relaxation Times": [time]}


def table(kind):
    return {**block(), **wall(), **held("Grip", "top", "y", "Way"), **guided(), **static(), "Histories/Way/Type": "Table",
            "Histories/Way/Table/Times": [0.0, 0.25, 0.5, 1.0], "Histories/Way/Table/Values": [0.0, 0.0, 0.02, 0.02],
            "Histories/Way/Table/Interpolation": kind}


def two_bodies(scheme):
    return {**pair(EQUILIBRIUM, height=2), "Initial Conditions/U/Blocks": ["upper_body"],
            "Initial Conditions/U/Velocity": [0.0, -0.5], **steps(scheme, *SHORT)}


SCENES = {
    **{f"a block on the wall, {scheme}": {**block(), **wall(), **moving(scheme)} for scheme in SCHEMES},
    **{f"a block before {law}": {**block(0.05 if law == "Bilinear Damage" else EQUILIBRIUM), **wall(Law=law), **moving()}
       for law in REPELLING},
    **{f"a block of {name} cells": {**block(), **element(name), **wall(), **moving()} for name in ELEMENTS},
    **{f"a brick of {name} cells": {**brick(), **element(name), **wall(), **moving(dimension=3)} for name in ELEMENTS},
    **{f"a block of {name} cells that is lifted": {**block(), **element(name), **wall(), **lifted()}
       for name in ELEMENTS},
    "a body of revolution": {**block(), "Mesh/Geometry": "Axisymmetric", **wall(), **moving()},
    "a sphere": {**block(), **round_wall("Sphere", Center=[2.0, -20.0], Radius=20.0), **moving()},
    "a cylinder": {**block(), **round_wall("Cylinder", Center=[2.0, -20.0], Radius=20.0), **moving()},
    "a load below the strength": solid(0.03),
    **{f"two bodies, {scheme}": two_bodies(scheme) for scheme in ("Newmark", "Average Vector Field", "Energy-Momentum")},
    "a resolved branch": {**block(), **held("Floor", "bottom", "xy"), **held("Grip", "top", "y", "Way"),
                          **ramp("Way", 0.1), **branch(0.5), **static(100)},
    "a branch in motion": {**block(), **branch(0.01), **wall(), **moving()},
    **{f"a table, {kind}": table(kind) for kind in ("Monotone", "Unlimited", "Linear", "Step")},
    "a nearly incompressible block": {**block(), "Materials/Body/Poisson's Ratio": 0.499,
                                      **element("Mean Dilatation"), **wall(), **lifted()},
}
