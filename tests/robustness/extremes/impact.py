"""Impacts from 1e-3 to 1e3 L0/T0 (bars of this material carry waves at 1400 L0/T0)."""
import maps
from gap import block
from runs import R0, SCHEMES, steps, table

SPEEDS = [float(f"1e{k}") for k in range(-3, 5)]


def thrown(runner, name, step_of):
    """outcomes[scheme][speed]; the block starts at the gap r0."""
    return [[runner(f"impact/{name}/{scheme}/{speed}", {**block(R0), **steps(scheme, step_of(speed), 400),
                                                        "Initial Conditions/Velocity": [0.0, -speed]})
             for speed in SPEEDS] for scheme in SCHEMES]


def study(runner, images):
    panels = [("Δt = 0.001 T₀", thrown(runner, "long", lambda v: 1e-3)),
              ("Δt = 0.0001 T₀", thrown(runner, "short", lambda v: 1e-4)),
              ("Δt = 0.0001 T₀, 0.01 r₀ a step at most", thrown(runner, "way", lambda v: min(1e-4, 0.01 * R0 / v)))]
    maps.picture([(title, outcomes, SPEEDS, "" if panel < 2 else "speed at the start [L₀/T₀]")
                  for panel, (title, outcomes) in enumerate(panels)], images / "extremes-impact")
    lines = []
    for title, outcomes in panels:
        lines += [title, "", *table(["scheme", *map(str, SPEEDS)], maps.rows(outcomes, SCHEMES, SPEEDS)), "",
                  *maps.messages(outcomes), ""]
    return lines
