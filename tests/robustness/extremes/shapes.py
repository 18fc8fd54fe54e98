"""Elements of aspect 1 to 1000 in motion, and surface sides as long: energy errors, the patch under tension; skew."""
from locking import LENGTH, cantilever, deflection, theory
from maps import word
from runs import ELEMENTS, EQUILIBRIUM, STEPS, box, element, held, number, ramp, steps, table, wall
from strain import stretch_stress

ASPECTS = [1, 3, 10, 30, 100, 300, 1000]
SKEWS = [0, 1, 2, 4, 8]
CASES = {
    "Average Vector Field": {}, "Energy-Momentum": {}, "Bathe Composite": {}, "Central Difference": {},
    "Average Vector Field, Mean Dilatation": element("Mean Dilatation"), "Average Vector Field, Enhanced": element("Enhanced"),
    "Average Vector Field, Quadratic": element("Quadratic"),
    "Average Vector Field, Q1C4": {"Interactions/Wall/Contact Element": "Q1C4"}}


def moving(dimension, aspect, scheme, extra):
    """A block of four elements a direction, each a unit high and `aspect` long, before the wall."""
    return {**box([4.0 * aspect] * (dimension - 1) + [4.0], [4] * dimension, [0.0] * (dimension - 1) + [1.1 * EQUILIBRIUM]),
            **wall(), **steps(scheme, 1e-4, 100), **extra}


def drawn(dimension, aspect, formulation):
    """A block on rollers, pulled along its long elements by a tenth."""
    rollers = ["left", "bottom"] if dimension == 2 else ["left", "front", "bottom"]
    entries = {**box([3.0 * aspect] + [3.0] * (dimension - 1), [3] * dimension), **element(formulation),
               "Time Integrator/Type": "Static", STEPS + "Time Step": 0.5, STEPS + "Final Time": 1.0,
               **ramp("Stretch", 0.3 * aspect), "Output/Reactions": ["right"]}
    for axis, side in zip("xyz", rollers):
        entries.update(held(side, side, axis))
    return {**entries, **held("right", "right", "x", "Stretch")}


def skewed(dimension, formulation, skew):
    """The beam of 40 by 4 (by 4) elements, sheared along its length by `skew` in the middle, not at its upright ends."""
    divisions, across = [40] + [4] * (dimension - 1), "xyz"[dimension - 1]
    return {**cantilever(dimension, 0.3, formulation, divisions),
            "Mesh/Map/X": f"x + {skew}*({across} - 0.5)*4*x*({LENGTH} - x)/{LENGTH}^2"}


def study(runner, images):
    del images
    rows = []
    for dimension in (2, 3):
        for name, extra in CASES.items():
            scheme = name.split(",")[0]
            rows.append([f"{dimension}D, {name}", *(word(runner(f"shapes/{dimension}/{name}/{aspect}",
                                                                moving(dimension, aspect, scheme, extra)))
                                                    for aspect in ASPECTS)])
    patches = []
    for dimension in (2, 3):
        for formulation in ELEMENTS:
            exact = 3.0 ** (dimension - 1) * stretch_stress(1.1, 0.2, dimension)
            outcomes = [runner(f"shapes/patch/{dimension}/{formulation}/{aspect}", drawn(dimension, aspect, formulation))
                        for aspect in ASPECTS]
            patches.append([f"{dimension}D, {formulation}",
                            *(number(abs(outcome.run["reaction_right_x"][-1] / exact - 1), 1) for outcome in outcomes)])
    beams = [[f"{dimension}D, {formulation}",
              *(number(deflection(runner(f"shapes/skew/{dimension}/{formulation}/{skew}",
                                         skewed(dimension, formulation, skew)), dimension, theory(dimension, 0.3)), 4)
                for skew in SKEWS)] for dimension in (2, 3) for formulation in ELEMENTS]
    return ["Energy errors after 100 steps", "", *table(["", *map(str, ASPECTS)], rows), "",
            "Force of a homogeneous tension, to the closed form", "", *table(["", *map(str, ASPECTS)], patches), "",
            "Deflection of a beam whose elements are skewed, to beam theory", "", *table(["skew", *map(str, SKEWS)], beams)]
