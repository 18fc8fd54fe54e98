"""Poisson's ratios from 0 to 0.4999, and elements of aspect 1 to 1000: locking, and its remedies, in bending."""
from runs import ELEMENTS, STEPS, box, element, held, number, ramp, table
import style

RATIOS = [0.0, 0.3, 0.45, 0.49, 0.499, 0.4999]
ASPECTS = [1, 3, 10, 30, 100, 300, 1000]
LENGTH = 20.0


def cantilever(dimension, ratio, formulation, divisions, length=LENGTH):
    """A linear elastic beam of height (and depth) 1, its end pulled up by a force of 1e-3/length^2."""
    lengths = [length] + [1.0] * (dimension - 1)
    up = [0.0] * (dimension - 1) + [1e-3 / length ** 2]
    return {**box(lengths, divisions), "Materials/Body/Model": "Linear Elastic", "Materials/Body/Poisson's Ratio": ratio,
            **element(formulation), "Time Integrator/Type": "Static",
            STEPS + "Time Step": 1.0, STEPS + "Final Time": 1.0, **held("clamp", "left", "all"), **ramp("Load", 1.0),
            "Boundary Conditions/Pull/Type": "Traction", "Boundary Conditions/Pull/Side Set": "right",
            "Boundary Conditions/Pull/Vector": up, "Boundary Conditions/Pull/History": "Load",
            "Output/Probes/Tip/Point": [length] + [0.5] * (dimension - 1), "Nonlinear Solver/Tolerance": 1e-8}


def theory(dimension, ratio, length=LENGTH):
    """Bernoulli and Timoshenko: F l^3/(3 E I) + F l/(kappa G), kappa = 10 (1 + nu)/(12 + 11 nu) (Cowper 1966)."""
    force, modulus = 1e-3 / length ** 2, 1 / (1 - ratio ** 2) if dimension == 2 else 1.0
    return force * (length ** 3 / (3 * modulus / 12) + length * 2 * (1 + ratio) * (12 + 11 * ratio) / (10 * (1 + ratio)))


def deflection(outcome, dimension, exact):
    """Of the tip, to the theory's."""
    return outcome.run["Tip_uy" if dimension == 2 else "Tip_uz"][-1] / exact if outcome.kind == "completed" else None


def by_ratio(runner, dimension):
    """Rows: formulation, deflections over theory for each Poisson's ratio."""
    divisions = [40, 4] if dimension == 2 else [40, 4, 4]
    return [[formulation, *(deflection(runner(f"locking/{dimension}/{formulation}/{ratio}",
                                              cantilever(dimension, ratio, formulation, divisions)), dimension,
                                       theory(dimension, ratio)) for ratio in RATIOS)] for formulation in ELEMENTS]


def by_aspect(runner, dimension):
    """Rows of one layer of eight elements of each aspect, nu = 0.3."""
    divisions = [8] + [1] * (dimension - 1)
    return [[formulation, *(deflection(runner(f"locking/aspect/{dimension}/{formulation}/{aspect}",
                                              cantilever(dimension, 0.3, formulation, divisions, 8.0 * aspect)),
                                       dimension, theory(dimension, 0.3, 8.0 * aspect)) for aspect in ASPECTS)]
            for formulation in ELEMENTS]


def picture(panels, path):
    style.use_style()
    figure, axes = style.plt.subplots(1, 2, figsize=(6.8, 2.9), layout="constrained")
    for axis, (values, label, tables) in zip(axes, panels):
        for dimension, rows in tables.items():
            for row, colour in zip(rows, style.COLORS):
                axis.plot(values, row[1:], "-o" if dimension == 2 else "--s", color=colour, markersize=3,
                          label=f"{row[0]}, {'quadrilaterals' if dimension == 2 else 'hexahedra'}")
        axis.set_xscale("log")
        axis.set_xlabel(label)
    axes[0].invert_xaxis()
    axes[0].set_ylabel("deflection / beam theory")
    axes[1].set_yscale("log")
    style.legend(figure, *axes[0].get_legend_handles_labels())
    style.save(figure, str(path), ["png"])
    style.plt.close(figure)


def study(runner, images):
    ratios = {dimension: by_ratio(runner, dimension) for dimension in (2, 3)}
    aspects = {dimension: by_aspect(runner, dimension) for dimension in (2, 3)}
    picture([([0.5 - ratio for ratio in RATIOS], "1/2 − Poisson's ratio", ratios),
             (ASPECTS, "aspect of the elements", aspects)], images / "extremes-locking")
    lines = []
    for title, tables, head in (("40 by 4 (by 4) elements", ratios, RATIOS),
                                ("one layer of eight elements", aspects, ASPECTS)):
        rows = [[f"{dimension}D, {row[0]}", *(number(value, 4) for value in row[1:])]
                for dimension, found in tables.items() for row in found]
        lines += [title, "", *table(["elements", *map(str, head)], rows), ""]
    return lines
