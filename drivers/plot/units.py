"""Units of the axes: L0, E0 and T0 of the scene, or SI units.

By default numbers stay as the results have them. After use_si() all that is read is converted: to SI units with the
prefix that makes the scene's own unit a number from 1 to 1000. Forces and energies of plane bodies are per depth."""
import re

from scene_file import ResultsError, existing, find, read_scene

# A quantity in a body of dimension d: its powers of L0, E0 and T0, its SI unit in space and, per depth, in the plane.
QUANTITIES = {
    "time": (lambda d: (0, 0, 1), "s", "s"),
    "length": (lambda d: (1, 0, 0), "m", "m"),
    "speed": (lambda d: (1, 0, -1), "m/s", "m/s"),
    "stress": (lambda d: (0, 1, 0), "Pa", "Pa"),
    "measure": (lambda d: (d - 1, 0, 0), "m²", "m"),
    "force": (lambda d: (d - 1, 1, 0), "N", "N/m"),
    "energy": (lambda d: (d, 1, 0), "J", "J/m"),
    "momentum": (lambda d: (d - 1, 1, 1), "N s", "N s/m"),
    "angular momentum": (lambda d: (d, 1, 1), "J s", "J s/m"),
}
SCENE_UNITS = "L₀", "E₀", "T₀"
POWERS = {1: "", 2: "²", 3: "³", -1: "⁻¹"}
PREFIXES = {-18: "a", -15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}

# Columns of history.csv; other columns are numbers, or the clock's seconds.
COLUMNS = [(r"time|time_step", "time"), (r"\w+_energy|external_work", "energy"), (r"linear_momentum_[xyz]", "momentum"),
           (r"angular_momentum_[xyz]", "angular momentum"), (r"contact_force_[xyz]|reaction_.*_[xyz]", "force"),
           (r"contact_measure", "measure"), (r"min_gap", "length"), (r".*_u[xyz]", "length"), (r".*_v[xyz]", "speed")]

# Units that Units of a scene may name, with a prefix or without: powers of m, kg, s and the factor.
SYMBOLS = {"m": ((1, 0, 0), 1.0), "g": ((0, 1, 0), 1e-3), "s": ((0, 0, 1), 1.0), "N": ((1, 1, -2), 1.0),
           "Pa": ((-1, 1, -2), 1.0), "J": ((2, 1, -2), 1.0)}
SPELT = {"f": -15, "p": -12, "n": -9, "u": -6, "µ": -6, "m": -3, "c": -2, "d": -1, "": 0, "k": 3, "M": 6, "G": 9, "T": 12}
KINDS = {"Length": (1, 0, 0), "Energy Density": (-1, 1, -2), "Time": (0, 0, 1)}

_shown = None  # the scales whose prefixes the axes have


def symbol(text):
    """Powers and factor of a symbol such as nm or GPa, or None."""
    for name, (powers, factor) in SYMBOLS.items():
        if text.endswith(name) and text[:-len(name)] in SPELT:
            return powers, factor * 10.0 ** SPELT[text[:-len(name)]]
    return None


def parse(text):
    """Factor in SI units and powers of m, kg and s of a quantity such as "2 GPa" or "1e9 J/m^3", or None."""
    match = re.fullmatch(r"\s*([-+.\deE]*\d\.?)\s*(\S.*?)\s*", text)
    if not match:
        return None
    try:
        factor = float(match[1])
    except ValueError:
        return None
    powers = [0, 0, 0]
    for sign, name, exponent in re.findall(r"([*/ .]|^)\s*([^\W\d]+)(?:\^(-?\d))?", match[2]):
        unit = symbol(name)
        if unit is None:
            return None
        power = (-1 if sign == "/" else 1) * int(exponent or 1)
        factor *= unit[1] ** power
        powers = [a + power * b for a, b in zip(powers, unit[0])]
    return factor, tuple(powers)


class Scales:
    """L0, E0 and T0 of a results folder in SI units, from the names in effective.xml."""

    def __init__(self, folder):
        path = existing(folder) / "effective.xml"
        scene = read_scene(folder)
        self.factors = []
        for name, powers in KINDS.items():
            entry = find(scene, f"Units/{name}")
            text = "" if entry is None else entry.get("value", "")
            quantity = parse(text)
            if quantity is None or quantity[1] != powers or not quantity[0] > 0:
                raise ResultsError(f"{path}: Units/{name} \"{text}\" is no SI unit that --si can convert")
            self.factors.append(quantity[0])

    def si(self, quantity, dimension):
        """One unit of the scene in SI units."""
        result = 1.0
        for factor, power in zip(self.factors, QUANTITIES[quantity][0](dimension)):
            result *= factor ** power
        return result


def use_si(folder):
    """From here on, all axes have SI units with prefixes that suit this folder's scene."""
    global _shown
    _shown = Scales(folder)


def scales(folder):
    """The scales of a folder, or None where nothing is converted."""
    return Scales(folder) if converts() else None


def converts():
    """Whether use_si() was called."""
    return _shown is not None


def prefix(quantity, dimension):
    """The exponent of the prefix of a quantity's SI unit, and the power of ten that it stands for."""
    name = si_name(quantity, dimension)
    power = 2 if name.endswith("²") else 1
    value = _shown.si(quantity, dimension) * (1 + 1e-9)
    exponent = max((e for e in PREFIXES if 10.0 ** (e * power) <= value), default=min(PREFIXES))
    return exponent, 10.0 ** (exponent * power)


def si_name(quantity, dimension):
    """A quantity's SI unit without a prefix."""
    return QUANTITIES[quantity][1 if dimension == 3 else 2]


def name(quantity, dimension):
    """The unit of a quantity as text: E₀ L₀, or N/m."""
    if converts():
        return PREFIXES[prefix(quantity, dimension)[0]] + si_name(quantity, dimension)
    powers = QUANTITIES[quantity][0](dimension)
    above, below = (" ".join(unit + POWERS[abs(power)] for unit, power in ((SCENE_UNITS[i], powers[i]) for i in (1, 0, 2))
                             if sign * power > 0) for sign in (1, -1))
    return f"{above}/{below}" if below else above


def factor(scales, quantity, dimension):
    """Returns the factor from a folder's numbers to those of the axes: 1 if nothing is converted."""
    return scales.si(quantity, dimension) / prefix(quantity, dimension)[1] if converts() else 1.0


def field_quantity(field):
    """The quantity of a field of fields.e, or None for a number."""
    if field in ("first_stress_invariant", "jacobian"):
        return None
    return "length" if field == "gap" else "stress" if re.search("stress|energy_density|pressure", field) else None


def convert_history(columns, scales, dimension):
    """Converts the columns of a history in place."""
    for column, values in columns.items():
        quantity = next((quantity for pattern, quantity in COLUMNS if re.fullmatch(pattern, column)), None)
        if quantity:
            columns[column] = values * factor(scales, quantity, dimension)
