"""The scenes and studies of xml/ in short forms, for bitwise.py and for tests/scenes/restarts_test.py."""
import os
import pathlib
import sys
import typing
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import ROOT, STEPS  # noqa: E402

XML = pathlib.Path(ROOT, "xml")
FINAL, SCHEME, RAMP = STEPS + "Final Time=", "Time Integrator/Type=", "Histories/Pull/Rate Ramp/Length="
BALL = [FINAL + "0.3"]
STRIP = [RAMP + "2", FINAL + "3"]  # a short run, too, shall see the end of its ramp
BLOCK = [FINAL + "2"]
SMALL_BLOCK = ["Mesh/Box/Divisions={14, 14, 14}", "Mesh/Box/Lengths={14, 14, 14}"]
SHORT_STEPS = [STEPS + "Time Step=0.005", RAMP + "0.1", FINAL + "0.1"]  # Automatic takes Chebyshev, matrix-free
HERTZ = ["Mesh/Box/Divisions={62, 46}"]
WAVES = ["Mesh/Box/Divisions={50, 16}", STEPS + "Time Step=0.05"]
JKR = ["Mesh/Box/Divisions={46, 11}", STEPS + "Time Step=0.05"]
CROSSED_CYLINDERS = [FINAL + "0.2", *("Mesh/Parts/" + part + "/Box/Divisions={12, 12, 1}" for part in ("upper", "lower"))]
SPATULA = ["Mesh/Spatula/Target Cells=4000", RAMP + "2", FINAL + "3"]
BEND = ["Mesh/Spatula/Target Cells=4000", FINAL + "0", "Boundary Conditions/Bend/Node Set=tip",
        "Boundary Conditions/Bend/Components=z", "Boundary Conditions/Bend/History=Bend", "Output/Reactions={tip}"]
RATE_PEEL = ["Mesh/Box/Lengths={40, 2}", "Mesh/Box/Divisions={80, 4}",
             "Output/Probes/end/Point={40, 1.254709287789268}", FINAL + "1000"]
FILM_FRICTION = ["Interactions/Wall/Friction/" + setting
                 for setting in ("Type=Constant Stress", "Stress=0.003", "Stiffness=1.5")]
BALL_ON_WALL = ["Mesh/Disk/Core Divisions=16", "Mesh/Disk/Rings=6", FINAL + "10"]
BALL_BRANCH = ["Materials/Ball/Maxwell Branches/" + setting for setting in ("Relaxation Times={3}", "Moduli={0.3}")]
TWO_BALLS = [FINAL + "0.3"]
BALLS_FRICTION = ["Interactions/Contact/Friction/" + setting
                  for setting in ("Type=Extended Amontons", "Coefficient=0.5")]
TWO_SPHERES = [STEPS + "Time Step=0.004", FINAL + "0.06"]
HAIRPIN = [FINAL + "0.12"]
CYLINDERS = ["Mesh/Parts/upper/Box/Divisions={36, 11}", "Mesh/Parts/lower/Box/Divisions={36, 11}",
             STEPS + "Time Step=0.05"]
T_PEEL = ["Mesh/Parts/upper/Box/Divisions={60, 2}", "Mesh/Parts/lower/Box/Divisions={60, 2}", FINAL + "3"]
ROUGH = ["Mesh/Box/Divisions={6, 6, 2}", FINAL + "1"]
SCANNED = ["Interactions/Sample/Obstacle=Height Field", "Interactions/Sample/Height Field/File=afm-rough.gsf",
           "Interactions/Sample/Height Field/Periodic=true"]
TRAPEZOID = ["Custom/Stages/One/Velocity={2, -2, -1, 0}", "Custom/Stages/One/Acceleration={4, -4, -4, -1}"]


class Form(typing.NamedTuple):
    """A run to compare."""
    name: str
    file: pathlib.Path
    settings: list
    ranks: int = 1
    program: str = "ixos"


class ShortStudy(typing.NamedTuple):
    """The changes that make a study short: values of axes, and of the lists Common, Reference/Settings and Errors."""
    common: dict
    axes: dict
    reference: dict
    errors: dict = {}


STEP, TIME = STEPS + "Time Step", STEPS + "Final Time"
COARSE = {"Mesh/Box/Divisions": "{160, 8}", RAMP[:-1]: "1.5", TIME: "2"}
TO_2 = {"Interval": "{0, 2}"}
STUDIES = {
    "ball-study": ShortStudy({TIME: "0.3"}, {"Time Step": ["0.01", "0.002"]}, {STEP: "0.0005"}),
    "ball-adaptive-study": ShortStudy({TIME: "0.4"}, {"Level": ["1", "2"]}, {STEP: "0.0005"}),
    "rate-peel-study": ShortStudy({TIME: "25"}, {"History": ["Static", "Second Order"], "Time Step": ["5"]},
                                  {STEP: "2.5"}, {"Interval": "{0, 25}"}),
    "spatula-elements-study": ShortStudy({TIME: "2", RAMP[:-1]: "2"},
                                         {"Elements": ["Q1C1 1500", "Q2 600"], "Time Step": ["0.5"]},
                                         {"Mesh/Spatula/Target Cells": "600", STEP: "0.25"}, TO_2),
    "spatula-study": ShortStudy({TIME: "2", RAMP[:-1]: "2"}, {"Time Step": ["0.5"], "Tolerance": ["1e-4", "1e-9"]},
                                {STEP: "0.25"}, TO_2),
    "strip-elements-study": ShortStudy({RAMP[:-1]: "1.5", TIME: "2", "Output/History Time Interval": "0.5"},
                                       {"Elements": ["Q1C4 80 x 4", "Enhanced, Q1C4 80 x 4", "Q2 80 x 2"],
                                        "Time Step": ["0.5"]},
                                       {"Mesh/Box/Divisions": "{80, 4}", STEP: "0.25"}, TO_2),
    "strip-options-study": ShortStudy(COARSE, {"Round": ["1"]}, {}, TO_2),
    "strip-study": ShortStudy({**COARSE, "Output/History Time Interval": "0.5"},
                              {"Contact Element": ["Q1C1", "Q1C4"], "Time Step": ["0.5", "0.1"]},
                              {"Mesh/Box/Divisions": "{160, 8}"}, TO_2),
}


def scene_forms(schemes):
    """Yields name, scene, settings and, if there are several, ranks. All runs repeat bit for bit: none uses MUMPS on
    several ranks."""
    def solver(*settings):
        return ["Linear Solver/" + setting for setting in ("Linear Solver Type=Belos", *settings)]

    for scheme in schemes:
        yield "ball, " + scheme, "ball", [*BALL, SCHEME + scheme]
    yield "ball, Custom", "ball", [*BALL, SCHEME + "Custom", *("Time Integrator/" + row for row in TRAPEZOID)]
    for bound in ("Maximum Gap Ratio=1.1", "Tolerance=0.01"):
        yield "ball, adaptive, " + bound, "ball", [FINAL + "0.4", STEPS + "Type=Adaptive", STEPS + "Adaptive/" + bound]
    yield "ball, two ranks", "ball", BALL, 2
    yield "strip", "strip", STRIP
    yield "strip, two ranks", "strip", STRIP, 2
    for formulation in ("Mean Dilatation", "Enhanced"):
        yield "strip, " + formulation, "strip", [*STRIP, "Materials/Strip/Element Formulation=" + formulation]
    yield "strip, Q1CH", "strip", [*STRIP, "Interactions/Wall/Contact Element=Q1CH"]
    yield "block-on-wall", "block-on-wall", BLOCK
    yield "block-on-wall, matrix-free, short steps", "block-on-wall", SMALL_BLOCK + SHORT_STEPS
    yield "block-on-wall, two ranks, matrix-free, short steps", "block-on-wall", SMALL_BLOCK + SHORT_STEPS, 2
    for operator in ("Matrix-Free", "Assembled"):
        yield f"block-on-wall, MueLu, {operator}", "block-on-wall", [
            *SMALL_BLOCK, *BLOCK, *solver("Preconditioner Type=MueLu", "Operator=" + operator)]
    for scene, short in (("hertz", HERTZ), ("jkr", JKR), ("jkr-spheres", [FINAL + "0.05"]), ("waviness", WAVES)):
        yield scene, scene, short
    yield "spatula", "spatula", SPATULA
    yield "spatula-stiff", "spatula-stiff", SPATULA
    yield "spatula, MueLu, Matrix-Free", "spatula", [
        *SPATULA, *solver("Preconditioner Type=MueLu", "Operator=Matrix-Free")]
    for scheme in ("Static", "Newmark"):
        yield "spatula-vibration, bent, " + scheme, "spatula-vibration", [*BEND, SCHEME + scheme]
    yield "mems-beam", "mems-beam", [FINAL + "0.1"]
    yield "pillar", "pillar", ["Mesh/Box/Divisions={20, 8}", FINAL + "0.5"]
    yield "pillar-backing", "pillar-backing", ["Mesh/Parts/pillar/Box/Divisions={20, 8}",
                                               "Mesh/Parts/backing/Box/Divisions={12, 12}", FINAL + "0.5"]
    yield "strip-front", "strip-front", [FINAL + "14"]
    yield "sphere-front", "sphere-front", ["Mesh/Box/Divisions={4, 4, 2}", FINAL + "0.8"]
    yield "drop", "drop", [FINAL + "0.06"]
    yield "drop, two ranks", "drop", [FINAL + "0.06", SCHEME + "Average Vector Field"], 2
    yield "roll", "roll", [FINAL + "0.1"]
    yield "press-wait-pull", "press-wait-pull", ["Stages/Pull/" + FINAL + "10"]
    yield "afm", "afm", [FINAL + "0.5"]
    yield "pillar-array", "pillar-array", [FINAL + "0.1"]
    yield "probe", "probe", ["Stages/Approach/" + FINAL + "8.5", "Stages/Retraction/" + FINAL + "9"]
    yield "afm-rough", "afm-rough", ROUGH
    yield "afm-rough, scanned", "afm-rough", [*ROUGH, *SCANNED]
    yield "film-peel", "film-peel", [FINAL + "2"]
    yield "film-peel, friction", "film-peel", [FINAL + "12", *FILM_FRICTION]
    yield "rate-peel", "rate-peel", RATE_PEEL
    yield "two-balls", "two-balls", TWO_BALLS
    yield "two-balls, two ranks", "two-balls", TWO_BALLS, 2
    yield "two-balls, Energy-Momentum", "two-balls", TWO_BALLS + [SCHEME + "Energy-Momentum"]
    yield "two-balls, friction", "two-balls", TWO_BALLS + BALLS_FRICTION
    yield "two-balls, friction, two ranks", "two-balls", TWO_BALLS + BALLS_FRICTION + [SCHEME + "Newmark"], 2
    yield "two-balls, Double Integral", "two-balls", TWO_BALLS + ["Interactions/Contact/Passes=Double Integral"]
    yield "two-spheres", "two-spheres", TWO_SPHERES, 2
    yield "two-spheres, friction", "two-spheres", TWO_SPHERES + BALLS_FRICTION + ["Interactions/Contact/Passes=Two"]
    yield "hairpin", "hairpin", HAIRPIN
    yield "t-peel", "t-peel", T_PEEL
    yield "stamp", "stamp", [FINAL + "0.5"]
    yield "cylinders", "cylinders", CYLINDERS
    yield "crossed-cylinders", "crossed-cylinders", CROSSED_CYLINDERS
    yield "gecko-drag", "gecko-drag", [STEPS + "Time Step=1", "Histories/Up/Rate Ramp/Start=2", FINAL + "8"]
    yield "spring-block", "spring-block", [FINAL + "0.5"]
    yield "restitution", "restitution", BALL_ON_WALL
    yield "restitution, Maxwell branch", "restitution", [*BALL_ON_WALL, *BALL_BRANCH]
    yield "sphere-hysteresis", "sphere-hysteresis", ["Mesh/Box/Divisions={46, 11}", FINAL + "20"]


def named(entry, tag, name):
    """Returns the child of an XML element with this tag and name, or nothing."""
    return next((child for child in entry.findall(tag) if child.get("name") == name), None)


def write_short_study(study, short, folder):
    """Writes a study in its short form into a folder. Returns the path of the file."""
    tree = ElementTree.parse(XML / (study + ".xml"))
    root = tree.getroot()
    scene = named(root, "Parameter", "Scene")
    scene.set("value", str(XML / scene.get("value")))
    axes = named(root, "ParameterList", "Axes")
    reference = named(named(root, "ParameterList", "Reference"), "ParameterList", "Settings")
    for entry, settings in ((named(root, "ParameterList", "Common"), short.common), (reference, short.reference),
                            (named(root, "ParameterList", "Errors"), short.errors)):
        for name, value in settings.items():
            parameter = named(entry, "Parameter", name)
            if parameter is None:
                parameter = ElementTree.SubElement(entry, "Parameter", name=name, type="string")
            parameter.set("value", value)
    for name, labels in short.axes.items():
        axis = named(axes, "ParameterList", name)
        values, settings = named(axis, "Parameter", "Values"), named(axis, "ParameterList", "Settings")
        if values is not None:
            values.set("value", "{" + ", ".join(labels) + "}")
        else:
            for setting in [setting for setting in settings if setting.get("name") not in labels]:
                settings.remove(setting)
    path = folder / (study + ".xml")
    tree.write(path)
    return path


def forgotten_files():
    """Returns the names of the files of xml/ that have no short form here."""
    covered = {scene for _, scene, *_ in scene_forms([])} | set(STUDIES)
    return sorted(str(path.relative_to(XML)) for path in XML.rglob("*.xml")
                  if str(path.relative_to(XML).with_suffix("")) not in covered)


def forms_to_compare(schemes, folder):
    """Returns all forms. Writes the short studies into the folder."""
    if forgotten_files():
        sys.exit(f"these files of xml/ have no short form in tests/compare/forms.py: {', '.join(forgotten_files())}")
    forms = [Form(name, XML / (scene + ".xml"), *rest) for name, scene, *rest in scene_forms(schemes)]
    return forms + [Form(study, write_short_study(study, short, folder), [], 1, "ixos-study")
                    for study, short in STUDIES.items()]


def forms_to_time():
    """Returns the forms whose times count."""
    settings = {"ball": [FINAL + "5"], "strip": [RAMP + "2", FINAL + "12"], "block-on-wall": BLOCK, "spatula": SPATULA,
                "two-spheres": TWO_SPHERES, "jkr": [*JKR, STEPS + "Time Step=0.01"]}
    return [Form(scene, XML / (scene + ".xml"), [*short, "Output/Checkpoint/Keep=0"])
            for scene, short in settings.items()]
