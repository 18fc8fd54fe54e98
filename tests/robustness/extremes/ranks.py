"""One element, ranks without elements, more ranks than elements: the same motion on any number of ranks."""
import numpy as np

from runs import EQUILIBRIUM, box, number, steps, table, wall

COUNT = 10
DIRECT = "Linear Solver/Linear Solver Types/Direct/Solver Type"
SOLVERS = {"KLU": {"Linear Solver/Linear Solver Type": "Direct", DIRECT: "KLU"},
           "MUMPS": {"Linear Solver/Linear Solver Type": "Direct", DIRECT: "MUMPS"},
           "CG, MueLu": {"Linear Solver/Linear Solver Type": "Belos", "Linear Solver/Preconditioner Type": "MueLu"},
           "CG, Ifpack2": {"Linear Solver/Linear Solver Type": "Belos", "Linear Solver/Preconditioner Type": "Ifpack2"}}


def scenes():
    """Name and entries."""
    for dimension in (2, 3):
        lower = [0.0] * (dimension - 1) + [1.1 * EQUILIBRIUM]
        one = {**box([2] * dimension, [1] * dimension, lower), **wall()}
        few = {**box([4] + [2] * (dimension - 1), [4] + [1] * (dimension - 1), lower), **wall()}
        for scheme in ("Average Vector Field", "Central Difference"):
            yield f"{dimension}D, one element, {scheme}", {**one, **steps(scheme, 1e-4, COUNT)}
            yield f"{dimension}D, four elements, {scheme}", {**few, **steps(scheme, 1e-4, COUNT)}
        for name, entries in SOLVERS.items():
            yield f"{dimension}D, one element, {name}", {**one, **steps("Average Vector Field", 1e-4, COUNT), **entries}
        yield f"{dimension}D, one element, Q1C4, fields", {
            **one, **steps("Average Vector Field", 1e-4, COUNT), "Interactions/Wall/Contact Element": "Q1C4",
            "Output/Fields Interval": 10}
        yield f"{dimension}D, one element, Enhanced, damped", {
            **one, **steps("Bathe Composite", 1e-4, COUNT), "Materials/Body/Element Formulation": "Enhanced",
            "Materials/Body/Stiffness Damping": 1e-5, "Materials/Body/Mass Damping": 1.0}


def difference(outcome, reference):
    """Of energies and gaps, relative to the largest."""
    if outcome.kind != "completed" or reference.kind != "completed":
        return f"{outcome.kind}: {outcome.message}"
    one, other = reference.run, outcome.run
    worst = max(np.abs(other[name] - one[name]).max() / max(np.abs(one[name]).max(), 1e-300)
                for name in ("total_energy", "kinetic_energy", "min_gap"))
    return number(worst, 1)


def study(runner, images):
    del images
    rows = []
    for name, entries in scenes():
        outcomes = [runner(f"ranks/{name}/{ranks}", entries, ranks, timeout=600) for ranks in (1, 2, 6)]
        rows.append([name, number(outcomes[0].energy_error(), 1) if outcomes[0].kind == "completed" else outcomes[0].message,
                     *(difference(outcome, outcomes[0]) for outcome in outcomes[1:])])
    return table(["scene", "energy error on one rank", "two ranks differ by", "six ranks differ by"], rows)
