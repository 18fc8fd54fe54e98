"""Spheres from 0.5 to 1e6 r0, walls with waves whose slopes reach 5, and walls that move at 1e-3 to 1e3 L0/T0."""
import math

import maps
from gap import block
from runs import EQUILIBRIUM, R0, SCHEMES, box, ramp, steps, table

RADII = [0.5, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6]
SLOPES = [0.01, 0.1, 0.5, 1.0, 2.0, 5.0]
SPEEDS = [float(f"1e{k}") for k in range(-3, 4)]
PERIOD = 8.0


def before(obstacle, **entries):
    """The entries of an interaction of the bottom with the obstacle; `Step_Margin=1.0` names "Step Margin"."""
    path = "Interactions/Wall/"
    return {path + "Side Set": "bottom", path + "Obstacle": obstacle,
            **{f"{path}{obstacle}/{name.replace('_', ' ')}": value for name, value in entries.items()}}


def body(gap):
    """Sixteen elements, 4 by 4, over the origin."""
    return box((4, 4), (4, 4), (-2, gap))


def on_sphere(radius, cavity=False):
    """A body that is released at rest over a sphere of that radius in r0, or in a cavity at its lowest point."""
    length = radius * R0
    if not cavity:
        return {**body(1.2 * EQUILIBRIUM), **before("Sphere", Radius=length, Center=[0.0, -length])}
    # The corners of the bottom are lower over the cavity than its middle.
    gap = 1.2 * EQUILIBRIUM
    depth = length - math.sqrt((length - gap) ** 2 - 4)
    return {**body(depth), **before("Sphere", Radius=length, Center=[0.0, length], Cavity=True)}


def on_waves(slope, measure):
    """A body that is thrown at the flank between crest and trough of a wave with that largest slope."""
    amplitude = slope * PERIOD / (2 * math.pi)
    return {**box((4, 4), (8, 8), (PERIOD / 4 - 2, amplitude + 1.2 * EQUILIBRIUM)),
            **before("Sine Wall", Amplitude=amplitude, Period=PERIOD, Gap=measure),
            "Initial Conditions/Velocity": [0.0, -10.0]}


def before_moving(speed):
    """A body at rest, a gap r0 from a wall that comes nearer at that speed."""
    return {**block(R0), **ramp("Approach", speed), "Interactions/Wall/Motion/Translation": ["-", "Approach"]}


def moved(runner):
    """outcomes[scheme][speed], 0.01 r0 a step at most; a wall that moves starts at that speed."""
    return [[runner(f"obstacles/moved/{scheme}/{speed}",
                    {**before_moving(speed), **steps(scheme, min(1e-3, 0.01 * R0 / speed), 400)}) for speed in SPEEDS]
            for scheme in SCHEMES]


def outcomes(runner, name, scenes, step):
    """outcomes[scheme][scene]; scenes: (label, entries)."""
    return [[runner(f"obstacles/{name}/{scheme}/{label}", {**entries, **steps(scheme, step, 300)})
             for label, entries in scenes] for scheme in SCHEMES]


def study(runner, images):
    cavities = [radius for radius in RADII if radius >= 10]
    panels = [("before a sphere", outcomes(runner, "sphere", [(r, on_sphere(r)) for r in RADII], 1e-3), RADII,
               "radius / r₀"),
              ("in a spherical cavity", outcomes(runner, "cavity", [(r, on_sphere(r, True)) for r in cavities], 1e-3),
               cavities, "radius / r₀"),
              ("on waves", outcomes(runner, "waves", [(s, on_waves(s, "Vertical")) for s in SLOPES], 1e-4), SLOPES,
               "largest slope of the wall"),
              ("before a wall that moves", moved(runner), SPEEDS, "speed [L₀/T₀]")]
    maps.picture(panels, images / "extremes-obstacles", SCHEMES, 2)
    lines = []
    for title, found, values, _ in panels:
        lines += [title, "", *table(["scheme", *map(str, values)], maps.rows(found, SCHEMES, values)), "",
                  *maps.messages(found), ""]
    return lines
