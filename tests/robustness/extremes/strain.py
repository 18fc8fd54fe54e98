"""One element stretched to 11 times its length, squeezed to a hundredth and sheared by 10, against closed forms."""
import numpy as np

from runs import ELEMENTS, STEPS, box, element, held, number, ramp, table

STRETCHES = [11.0, 3.0, 1 + 1e-3, 1 + 1e-6, 1 + 1e-9, 0.5, 0.2, 1 / 11, 0.01]
RATIOS = [0.0, 0.2, 0.4999]


def lame(ratio):
    return 1 / (2 * (1 + ratio)), ratio / ((1 + ratio) * (1 - 2 * ratio))


def stretch_stress(stretch, ratio, dimension):
    """P_11 of a neo-Hookean bar with free sides (in plane strain one of them): their stretch by bisection."""
    mu, second = lame(ratio)
    sides = dimension - 1
    log, one = np.log, np.log(stretch)

    def side_stress(l):  # over mu + second, in l = ln of the sides' stretch
        return 2 * mu * np.sinh(l) + second * (one + sides * l) * np.exp(-l)

    low, high = -abs(one) - 1e-12, abs(one) + 1e-12
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if side_stress(middle) < 0 else (low, middle)
    volume = one + sides * (low + high) / 2
    return mu * (stretch ** 2 - 1) / stretch + second * volume / stretch if abs(stretch - 1) > 1e-4 else \
        (mu * np.expm1(2 * one) + second * volume) / stretch


def stretched(dimension, ratio, formulation, stretch, count):
    """A unit element on rollers, its right side driven."""
    rollers = ["left", "bottom"] if dimension == 2 else ["left", "front", "bottom"]
    entries = {**box([1] * dimension, [1] * dimension), "Materials/Body/Poisson's Ratio": ratio,
               **element(formulation), "Time Integrator/Type": "Static",
               STEPS + "Time Step": 1 / count, STEPS + "Final Time": 1.0, **ramp("Stretch", stretch - 1),
               "Output/Reactions": ["right"]}
    for axis, side in zip("xyz", rollers):
        entries.update(held(side, side, axis))
    return {**entries, **held("right", "right", "x", "Stretch")}


def sheared(dimension, ratio, formulation, shear, count):
    """A unit element whose top is driven along its bottom; neither moves up or down."""
    top = {**held("base", "bottom", "all"), **held("top", "top", "x", "Shear"),
           **held("level", "top", "y" if dimension == 2 else "yz")}
    return {**box([1] * dimension, [1] * dimension), "Materials/Body/Poisson's Ratio": ratio,
            **element(formulation), "Time Integrator/Type": "Static",
            STEPS + "Time Step": 1 / count, STEPS + "Final Time": 1.0, **ramp("Shear", shear), **top,
            "Output/Reactions": ["top"]}


def squeezed(dimension, ratio, formulation):
    """4 x 4 (x 4) elements between held ends, squeezed to a hundredth of their height in 99 load steps."""
    return {**box([1] * dimension, [4] * dimension), "Materials/Body/Poisson's Ratio": ratio,
            **element(formulation), "Time Integrator/Type": "Static",
            STEPS + "Time Step": 0.01, STEPS + "Final Time": 0.99, **ramp("Squeeze", -1.0), **held("base", "bottom", "all"),
            **held("top", "top", "xy"[:dimension - 1]), **held("press", "top", "xyz"[dimension - 1], "Squeeze")}


def least_height(outcome):
    """The last height that was reached; the reason where it was not the end."""
    height = 1 - outcome.run["time"][-1]
    return number(height) if outcome.kind == "completed" else f"{number(height)}: {outcome.message.split(': ', 1)[-1]}"


def verdict(outcome, reaction, exact):
    if outcome.kind == "completed":
        return number(abs(outcome.run[reaction][-1] / exact - 1), 1)
    return outcome.kind if outcome.kind != "failed" else f'fails at {number(outcome.run["time"][-1])}'


def study(runner, images):
    del images
    rows = []
    for dimension in (2, 3):
        for ratio in RATIOS:
            for formulation in ELEMENTS:
                row = [f"{dimension}D", f"{ratio:g}", formulation]
                for stretch in STRETCHES:
                    best = None
                    for count in (1, 10, 100):
                        outcome = runner(f"strain/{dimension}/{ratio}/{formulation}/{stretch}/{count}",
                                         stretched(dimension, ratio, formulation, stretch, count))
                        word = verdict(outcome, "reaction_right_x", stretch_stress(stretch, ratio, dimension))
                        best = word if count == 1 else f"{word} ({count})"
                        if outcome.kind == "completed":
                            break
                    row.append(best)
                outcome = runner(f"strain/{dimension}/{ratio}/{formulation}/shear",
                                 sheared(dimension, ratio, formulation, 10.0, 10))
                rows.append([*row, verdict(outcome, "reaction_top_x", lame(ratio)[0] * 10)])
    blocks = [[f"{dimension}D", f"{ratio:g}", formulation,
               least_height(runner(f"strain/squeezed/{dimension}/{ratio}/{formulation}", squeezed(dimension, ratio, formulation)))]
              for dimension in (2, 3) for ratio in RATIOS for formulation in ELEMENTS]
    return [*table(["", "nu", "elements", *(f"{stretch:.10g}" for stretch in STRETCHES), "shear 10"], rows), "",
            *table(["", "nu", "4 elements an edge, squeezed between held ends", "height reached"], blocks)]
