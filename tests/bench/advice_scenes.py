"""Random scenes of three kinds, each with a quantity and a tolerance, and the settings of a fine reference for each.

draw(seed, number) gives a case: a dictionary with its number, kind, settings, quantity and tolerance. The kinds are

- ball: an elastic disk that meets a wall (xml/ball.xml);
- strip: a short strip that is peeled off a wall (xml/strip.xml);
- block: a small block in three dimensions before a wall.

All have other gaps, laws, speeds, thicknesses, ramps, materials, schemes and contact elements. They are so small that a
run takes seconds. The forces before ball and block have a longer range than those of xml/, so that coarse meshes
resolve them.
"""
import pathlib
import random

ROOT = pathlib.Path(__file__).resolve().parents[2]
STEP = "Time Integrator/Time Step Control/Time Step"
END = "Time Integrator/Time Step Control/Final Time"
SCHEME = "Time Integrator/Type"
WALL = "Interactions/Wall/"
ELEMENT = WALL + "Contact Element"
BODY = {"ball": "Materials/Ball/", "strip": "Materials/Strip/", "block": "Materials/Block/"}

BLOCK = """<ParameterList name="Block">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Block"/></ParameterList>
  <ParameterList name="Interactions"><ParameterList name="Wall">
    <Parameter name="Side Set" type="string" value="bottom"/>
    <Parameter name="Gamma L" type="double" value="2.5"/>
    <Parameter name="Gamma W" type="double" value="25"/></ParameterList></ParameterList>
  <ParameterList name="Time Integrator"><Parameter name="Type" type="string" value="Average Vector Field"/>
    <ParameterList name="Time Step Control"><Parameter name="Final Time" type="double" value="0.1"/>
      <Parameter name="Time Step" type="double" value="0.0005"/></ParameterList></ParameterList>
</ParameterList>
"""


def number(any_of, least, most):
    return "%.4g" % any_of.uniform(least, most)


def law(any_of, kind):
    """Returns the settings of the wall's law, and its equilibrium gap."""
    weaker = 5 if kind == "block" else 1  # so that coarse meshes resolve its waves, too
    settings, gap = {WALL + "Gamma W": number(any_of, 15 * weaker, 60 * weaker)}, 0.255
    strength = any_of.uniform(0.03, 0.1) / weaker
    work = any_of.uniform(0.02, 0.08)
    if kind != "strip":
        length = any_of.uniform(1, 2.5)
        settings[WALL + "Gamma L"] = "%.4g" % (1 / length)
        gap = 0.637 * length
        work = strength * length * any_of.uniform(0.6, 1.2)
    if any_of.random() < 0.3:
        settings = {WALL + "Law": "Morse", WALL + "Morse/Work of Adhesion": "%.4g" % work,
                    WALL + "Morse/Strength": "%.4g" % strength, WALL + "Morse/Equilibrium Gap": "%.4g" % gap}
    return settings, gap


def ball(any_of, settings, gap):
    settings["Mesh/Disk/Center"] = "{0, %.6g}" % (5 + gap * any_of.uniform(1, 3))
    settings["Mesh/Disk/Core Divisions"], settings["Mesh/Disk/Rings"] = "8", "4"
    settings["Materials/Ball/Young's Modulus"] = number(any_of, 0.3, 2)
    settings["Materials/Ball/Density"] = "%.3g" % (5e-7 * any_of.uniform(0.5, 2))
    settings["Initial Conditions/Velocity"] = "{0, -%s}" % number(any_of, 2, 20)
    settings[SCHEME] = any_of.choice(["Average Vector Field", "Newmark", "Generalized-Alpha"])
    settings[STEP], settings[END] = "0.001", number(any_of, 0.05, 0.15)
    return ["peak contact_force_y", "rms contact_force_y", "peak elastic_energy", "final linear_momentum_y"]


def strip(any_of, settings, _):
    settings["Mesh/Box/Lengths"] = "{100, %s}" % number(any_of, 4, 12)
    settings["Mesh/Box/Divisions"] = "{80, 4}"
    settings["Mesh/Sets/contact/Upper"] = "{%d, 1}" % any_of.choice([60, 75, 90])
    settings["Output/Probes/edge/Point"] = "{100, 0.254709287789268}"
    settings["Time Integrator/Stop/Peeled/Probe/Limit"] = "1e6"  # a strip that is off the wall goes on
    settings[ELEMENT] = any_of.choice(["Q1C1", "Q1C2", "Q1C4"])
    settings["Histories/Pull/Rate Ramp/Rate"] = number(any_of, 0.3, 1)
    settings["Histories/Pull/Rate Ramp/Length"] = number(any_of, 5, 20)
    settings["Materials/Strip/Young's Modulus"] = number(any_of, 0.5, 2)
    settings[SCHEME] = any_of.choice(["Gautam-Sauer Composite", "Bathe Composite", "Generalized-Alpha"])
    settings[STEP], settings[END] = "0.1", "25"
    return ["peak reaction_right_y [5, 20]", "mean reaction_right_y [5, 20]", "rms reaction_right_y [5, 20]",
            "work [0, 20]", "final elastic_energy", "value reaction_right_y at 15"]


def block(any_of, settings, gap):
    settings["Mesh/Box/Dimension"] = "3"
    settings["Mesh/Box/Lengths"] = "{2, 2, %s}" % number(any_of, 1, 2)
    settings["Mesh/Box/Divisions"] = "{4, 4, 4}"
    settings["Mesh/Box/Lower"] = "{0, 0, %.4g}" % (gap * any_of.uniform(1, 1.5))
    settings["Initial Conditions/Velocity"] = "{0, 0, -%s}" % number(any_of, 2, 8)
    settings["Materials/Block/Young's Modulus"] = number(any_of, 1, 3)
    settings["Materials/Block/Density"] = "%.3g" % (5e-7 * any_of.uniform(0.5, 2))
    settings["Materials/Block/Model"] = any_of.choice(["Neo-Hooke", "Linear Elastic", "Saint Venant-Kirchhoff"])
    settings[SCHEME] = any_of.choice(["Average Vector Field", "Newmark", "Generalized-Alpha"])
    settings[STEP], settings[END] = "0.0005", number(any_of, 0.03, 0.08)
    return ["peak contact_force_z", "rms contact_force_z", "energy error", "peak elastic_energy",
            "peak kinetic_energy"]


def draw(seed, number_of_case):
    """Returns a case: a scene, its changes, a quantity, a tolerance."""
    any_of = random.Random(f"{seed} {number_of_case}")
    kind = any_of.choice(["ball", "strip", "block"])
    settings, gap = law(any_of, kind)
    quantities = {"ball": ball, "strip": strip, "block": block}[kind](any_of, settings, gap)
    return {"number": number_of_case, "kind": kind, "settings": settings, "quantity": any_of.choice(quantities),
            "tolerance": any_of.choice([0.1, 0.05, 0.02] if kind == "block" else [0.05, 0.02, 0.01])}


def scene_of(case, folder):
    """Returns the path of the case's scene."""
    if case["kind"] != "block":
        return ROOT / "xml" / (case["kind"] + ".xml")
    path = folder / "block.xml"
    path.write_text(BLOCK, encoding="utf-8")
    return path


def scaled(settings, step, cells):
    """Returns the settings with a multiple of the step and of the cells along each edge; None if that is not whole."""
    result = dict(settings)
    for name, value in settings.items():
        last = name.rsplit("/", 1)[-1]
        if last == "Time Step":
            result[name] = repr(float(value) * step)
        elif last in ("Divisions", "Core Divisions", "Rings"):
            numbers = [int(n) * cells for n in value.strip("{}").split(",")]
            if any(n != int(n) or n < 1 for n in numbers) or (last == "Core Divisions" and numbers[0] % 2):
                return None
            text = ", ".join(str(int(n)) for n in numbers)
            result[name] = "{%s}" % text if "{" in value else text
    return result


def references(case):
    """Returns the settings of the reference, and of a coarser one that tells how exact it is.

    Both have quadratic cells, whose number along an edge is REFINED times that of the scene, and half of the scene's
    step, or half of that many cells and twice that step.
    """
    quadratic = {"Mesh/Cell Order": "2", ELEMENT: "Q2C2"}
    scheme = {} if case["kind"] == "strip" else {SCHEME: "Generalized-Alpha"}
    own = {**case["settings"], **quadratic, **scheme}
    step, cells = REFINED[case["kind"]]
    return scaled(own, step, cells), scaled(own, 2 * step, cells / 2)


REFINED = {"ball": (0.25, 2), "strip": (0.5, 2), "block": (0.5, 2)}
