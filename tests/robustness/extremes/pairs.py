"""Two bodies: gaps from 1e-2 to 1e3 r0, sides of which one is up to 20 times as long as the other, radii down to the
length of a side, and speeds of up to ten lengths of the bodies a step."""
import maps
from runs import R0, SCHEMES, steps, table

GAPS = [0.01, 0.1, 0.3, 0.5, 1.0, 10.0, 100.0, 1000.0]
RATIOS = ["1:20", "1:5", "1:1", "5:1", "20:1"]
SIDES = [8, 16, 32, 64]
LENGTHS = [0.01, 0.1, 1.0, 10.0]
LENGTH = 4.0
DENSE_SCHEMES = ["Average Vector Field", "Newmark"]


def bodies(parts, secondary, primary):
    """Two parts, upper and lower, whose surfaces interact."""
    entries = {"Mesh/Type": "Parts", "Interactions/Pair/Side Set": secondary,
               "Interactions/Pair/Primary Side Set": primary}
    for name, part in parts.items():
        entries.update({f"Mesh/Parts/{name}/{path}": value for path, value in part.items()})
        entries[f"Materials/{name}/Block"] = name + "_body"
    return entries


def blocks(gap, upper=4, lower=5):
    """Two blocks of 4 by 4, of that many cells along the faces that meet."""
    def block(cells, bottom):
        return {"Type": "Box", "Box/Dimension": 2, "Box/Lengths": [LENGTH, LENGTH], "Box/Divisions": [cells, 4],
                "Box/Lower": [0.0, bottom]}
    return bodies({"upper": block(upper, gap), "lower": block(lower, -LENGTH)}, "upper_bottom", "lower_top")


def disks(sides):
    """Two disks with that many sides, released near each other."""
    disk = {"Type": "Disk", "Disk/Diameter": LENGTH, "Disk/Core Divisions": sides // 4}
    return bodies({"upper": {**disk, "Disk/Center": [0.3, LENGTH + R0]}, "lower": disk}, "upper_surface",
                  "lower_surface")


def splines(sides):
    return {**disks(sides), "Interactions/Pair/Smoothing": "Spline"}


def thrown(lengths, step):
    """The upper block flies at the lower one, by that many of its lengths a step."""
    return {**blocks(3 * R0), "Initial Conditions/Blocks/Blocks": ["upper_body"],
            "Initial Conditions/Blocks/Velocity": [0.0, -lengths * LENGTH / step]}


def dense(entries):
    """The double integral, with points 0.06 to 0.1 apart on sides of 1 to 1.6."""
    return {**entries, "Interactions/Pair/Passes": "Double Integral", "Interactions/Pair/Surface Points": 16}


def outcomes(runner, name, scenes, step, count=200, schemes=SCHEMES):
    """outcomes[scheme][scene]; scenes: (label, entries). Average Vector Field takes 8 points in time."""
    return [[runner(f"pairs/{name}/{scheme}/{label}", {**entries, **steps(scheme, step, count),
                                                       "Time Integrator/Average Vector Field/Interaction Points": 8})
             for label, entries in scenes] for scheme in schemes]


def of_ratio(ratio):
    upper, lower = (4 * int(part) for part in ratio.split(":"))
    return blocks(1.2 * R0, upper, lower)


def study(runner, images):
    panels = [("released at a gap", outcomes(runner, "gap", [(g, blocks(g * R0)) for g in GAPS], 1e-3), GAPS, "gap / r₀"),
              ("sides of secondary to primary surface",
               outcomes(runner, "ratio", [(r, of_ratio(r)) for r in RATIOS], 1e-3), RATIOS, "number of sides"),
              ("disks of few sides", outcomes(runner, "sides", [(n, disks(n)) for n in SIDES], 1e-3), SIDES, "sides"),
              ("disks of few sides, splines", outcomes(runner, "splines", [(n, splines(n)) for n in SIDES], 1e-3),
               SIDES, "sides"),
              ("thrown", outcomes(runner, "thrown", [(x, thrown(x, 1e-3)) for x in LENGTHS], 1e-3, 20), LENGTHS,
               "lengths a step")]
    lines = []
    for title, found, values, _ in panels:
        lines += [title, "", *table(["scheme", *map(str, values)], maps.rows(found, SCHEMES, values)), "",
                  *maps.messages(found), ""]
    for title, scenes, values in (("double integral, released at a gap", [blocks(g * R0) for g in GAPS], GAPS),
                                  ("double integral, sides", map(of_ratio, RATIOS), RATIOS),
                                  ("double integral, disks of few sides", map(disks, SIDES), SIDES)):
        labels = zip(values, map(dense, scenes))
        found = outcomes(runner, title, list(labels), 1e-3, schemes=DENSE_SCHEMES)
        lines += [title, "", *table(["scheme", *map(str, values)], maps.rows(found, DENSE_SCHEMES, values)), "",
                  *maps.messages(found), ""]
    return lines
