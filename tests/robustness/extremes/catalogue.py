"""Every law of the catalogue over decades of its strength and its range."""
import maps
from gap import block
from runs import R0, steps, table

EXACT = "Average Vector Field, exact mean"
SCHEMES = ["Newmark", "Bathe Composite", "Average Vector Field", EXACT, "Energy-Momentum"]
LAW = "Interactions/Wall/Law"
# Laws that only attract act beside a penalty that stops the body at this gap.
STOP = {"Interactions/Stop/Side Set": "bottom", "Interactions/Stop/Law": "Penalty", "Interactions/Stop/Penalty/Stiffness": 100.0,
        "Interactions/Stop/Penalty/Gap": 0.1}


def scene(law, **entries):
    """A body that is thrown at the wall with 1 L0/T0 from the gap r0."""
    partner = STOP if law in ("Smooth Dugdale", "Triangle", "Electrostatic", "Capillary") else {}
    return {**block(R0), LAW: law, **partner, "Initial Conditions/Velocity": [0.0, -1.0],
            **{f"Interactions/Wall/{law}/{name.replace('_', ' ')}": value for name, value in entries.items()}}


DECADES = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0]
STIFF = [1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4]
# name: (label, values, scene of a value)
CASES = {
    "mie-work": ("Mie 12-6, work of adhesion [E₀ L₀]", DECADES,
                 lambda v: scene("Mie", Repulsive_Exponent=12.0, Attractive_Exponent=6.0, Constants="Gap", Work_of_Adhesion=v,
                                 Equilibrium_Gap=0.25)),
    "mie-exponent": ("Mie n-2, repulsive exponent", [3.0, 4.0, 8.0, 12.0, 20.0, 40.0, 60.0],
                     lambda v: scene("Mie", Repulsive_Exponent=v, Constants="Gap", Work_of_Adhesion=1e-3,
                                     Equilibrium_Gap=0.25)),
    "xu-needleman-work": ("Xu-Needleman, work of adhesion [E₀ L₀]", DECADES,
                          lambda v: scene("Xu-Needleman", Constants="Length", Work_of_Adhesion=v,
                                          Characteristic_Length=0.1)),
    "xu-needleman-length": ("Xu-Needleman, length [L₀]", [1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0],
                            lambda v: scene("Xu-Needleman", Constants="Length", Work_of_Adhesion=1e-3,
                                            Characteristic_Length=v)),
    "morse-work": ("Morse, work of adhesion [E₀ L₀]", DECADES,
                   lambda v: scene("Morse", Work_of_Adhesion=v, Strength=10 * v)),
    "penalty": ("Penalty, stiffness [E₀/L₀]", STIFF, lambda v: scene("Penalty", Stiffness=v)),
    "barrier": ("Log Barrier, stiffness [E₀/L₀]", STIFF, lambda v: scene("Log Barrier", Stiffness=v)),
    "dugdale": ("Smooth Dugdale, strength [E₀]", DECADES,
                          lambda v: scene("Smooth Dugdale", Strength=v, Work_of_Adhesion=0.3 * v)),
    "triangle": ("Triangle, strength [E₀]", DECADES,
                 lambda v: scene("Triangle", Strength=v, Work_of_Adhesion=0.3 * v)),
    "electrostatic": ("Electrostatic, force constant [E₀ L₀²]", [value * 1e-2 for value in DECADES],
                      lambda v: scene("Electrostatic", Constants="Force", Force_Constant=v, Insulation=0.1)),
}


def scheme_of(name):
    """1000 steps with a scheme. The default of Average Vector Field has eight points in time, which miss kinks of laws."""
    if name == EXACT:
        return {**steps("Average Vector Field", 1e-3, 1000), "Time Integrator/Average Vector Field/Interaction Points": 0}
    return steps(name, 1e-3, 1000)


def outcomes(runner, name, values, scene_of):
    return [[runner(f"catalogue/{name}/{scheme}/{value}", {**scene_of(value), **scheme_of(scheme)})
             for value in values] for scheme in SCHEMES]


def study(runner, images):
    found = {name: outcomes(runner, name, values, scene_of) for name, (_, values, scene_of) in CASES.items()}
    maps.picture([(label, found[name], values, "") for name, (label, values, _) in CASES.items()],
                 images / "extremes-catalogue", SCHEMES, 2)
    lines = []
    for name, (label, values, _) in CASES.items():
        lines += [label, "", *table(["scheme", *(f"{value:g}" for value in values)],
                                    maps.rows(found[name], SCHEMES, values)), "", *maps.messages(found[name]), ""]
    return lines
