"""Densities from 1e3 down to what a double holds: the limit without inertia is the scheme Static."""
from runs import SCHEMES, box, held, number, steps, table

DENSITIES = [1e3, 1.0, 1e-3, 5e-7, 1e-9, 1e-20, 1e-100, 1e-200, 1e-300, 1e-320]
END = 1.5


def pulled(scheme, density, step=0.05):
    """A bar, stretched by a tenth in one T0, then held; elastic waves take 4 sqrt(density) T0 along it."""
    return {**box((4, 1), (4, 1)), "Materials/Body/Density": density, **steps(scheme, step, round(END / step)),
            **held("wall", "left", "xy"), **held("pull", "right", "x", "Pull"), "Histories/Pull/Type": "Ramp",
            "Histories/Pull/Ramp/Value": 0.4, "Histories/Pull/Ramp/Length": 1.0, "Output/Reactions": ["right"]}


def study(runner, images):
    del images
    static = runner("density/Static", pulled("Static", 1.0)).run["reaction_right_x"][-1]
    rows, notes = [], {}
    for scheme in SCHEMES:
        row = [scheme]
        for density in DENSITIES:
            entries = pulled(scheme, density)
            if scheme == "Central Difference" and 1e-12 < density < 1:
                entries = {**entries, "Output/History Interval": 1000}
            if scheme == "Central Difference" and density == 1e-20:
                row.append("5e10 steps")
                continue
            outcome = runner(f"density/{scheme}/{density}", entries, timeout=120)
            if outcome.kind == "completed":
                row.append(number(abs(outcome.run["reaction_right_x"][-1] / static - 1), 1))
            else:
                row.append(outcome.kind)
                notes.setdefault(f"{outcome.kind}, {outcome.message}", []).append(f"{scheme} at {density:g}")
        rows.append(row)
    return [f"Reaction of Static: {static:.6g} E0 L0; the others' relative difference from it at the end:", "",
            *table(["scheme", *(f"{density:g}" for density in DENSITIES)], rows), "",
            *(f"- {', '.join(where)}: {what}" for what, where in notes.items())]
