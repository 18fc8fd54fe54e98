"""Units of the axes: L0, E0 and T0 of the scene, or SI units.

By default numbers stay as the results have them. After use_si() all that is read is converted: to SI units with the
prefix that makes the scene's own unit a number from 1 to 1000. Forces and energies of plane bodies are per depth."""
import re

import result_files
from scene_file import ResultsError, existing

# A quantity in a body of dimension d: its powers of L0, E0 and T0, its SI unit in space and, per depth, in the plane.
QUANTITIES = {
    "time": (lambda d: (0, 0, 1), "s", "s"),
    "length": (lambda d: (1, 0, 0), "m", "m"),
    "speed": (lambda d: (1, 0, -1), "m/s", "m/s"),
    "acceleration": (lambda d: (1, 0, -2), "m/s²", "m/s²"),
    "stress": (lambda d: (0, 1, 0), "Pa", "Pa"),
    "measure": (lambda d: (d - 1, 0, 0), "m²", "m"),
    "force": (lambda d: (d - 1, 1, 0), "N", "N/m"),
    "surface energy": (lambda d: (1, 1, 0), "N/m", "N/m"),
    "energy": (lambda d: (d, 1, 0), "J", "J/m"),
    "moment": (lambda d: (d, 1, 0), "N m", "N"),
    "momentum": (lambda d: (d - 1, 1, 1), "N s", "N s/m"),
    "angular momentum": (lambda d: (d, 1, 1), "J s", "J s/m"),
}
SCENE_UNITS = "L₀", "E₀", "T₀"
POWERS = {1: "", 2: "²", 3: "³", -1: "⁻¹"}
PREFIXES = {-18: "a", -15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}

# Columns of history.csv; other columns are numbers, or the clock's seconds.
COLUMNS = [(r"time|time_step", "time"), (r"\w+_energy|external_work|dissipated_.*", "energy"),
           (r"linear_momentum_[xyz]", "momentum"), (r"angular_momentum_[xyz]", "angular momentum"),
           (r"contact_force_(.*_)?[xyz]|friction_force_.*_[xyz]|reaction_.*_[xyz]", "force"),
           (r"(contact_)?moment_.*_[xyz]", "moment"), (r"min_gap(_.*)?|mean_slip_.*", "length"),
           (r"contact_measure(_.*)?|sliding_measure_.*|sticking_measure_.*", "measure"),
           (r".*_u[xyz]|norm_displacement", "length"), (r".*_v[xyz]|norm_velocity", "speed"),
           (r"norm_acceleration", "acceleration"),
           (r"norm_(.*_stress|stress|(dissipated_)?energy_density)", "stress")]

# Names in `units` of summary.json, where they are others.
SUMMARY_NAMES = {"speed": "velocity", "surface energy": "", "momentum": "linear_momentum",
                 "angular momentum": "angular_momentum", "measure": "contact_measure"}

_shown = None  # the scales whose prefixes the axes have


class Scales:
    """L0, E0 and T0 of a results folder in SI units, from `units` of its summary.json."""

    def __init__(self, folder):
        path = existing(folder) / "summary.json"
        if not path.is_file():
            raise ResultsError(f"{path}: --si needs this file, which Ixos writes at the end of a run")
        try:
            known = result_files.read_summary(path)["units"]
            self.factors = [float(known[kind]["si"]) for kind in ("length", "stress", "time")]
        except (ValueError, KeyError, TypeError):
            raise ResultsError(f"{path}: it has no units, which --si needs: run the scene with this version") from None

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
    power = 2 if name == "m²" else 1  # a prefix is squared with its unit
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
    if re.fullmatch("gap(_.*)?|slip_.*|displacement(_?[XYZ])?", field):
        return "length"
    if re.fullmatch("velocity(_?[XYZ])?", field):
        return "speed"
    if re.fullmatch("acceleration(_?[XYZ])?", field):
        return "acceleration"
    if re.fullmatch("reaction(_?[XYZ])?", field):
        return "force"
    if field.startswith(("normal_", "sliding_", "damage_")):  # of an interaction with any name
        return None
    if field.startswith("dissipated_") and field != "dissipated_energy_density":
        return "surface energy"
    if field.startswith(("pressure_", "traction_", "friction_")):
        return "stress"
    return "stress" if re.search("stress|energy_density|pressure|interaction_traction", field) else None


def column_quantity(column):
    """The quantity of a column of history.csv, or None for a number."""
    return next((quantity for pattern, quantity in COLUMNS if re.fullmatch(pattern, column)), None)


def summary_name(column):
    """The name in `units` of summary.json of what a column of history.csv has; None for a number."""
    quantity = column_quantity(column)
    return SUMMARY_NAMES.get(quantity, quantity)


def symbol(expression):
    """A unit of the scene as axes show it: E0 L0^2 as E₀ L₀²."""
    for plain, shown in (*((name[0] + "0", name) for name in SCENE_UNITS), ("^2", POWERS[2]), ("^3", POWERS[3])):
        expression = expression.replace(plain, shown)
    return expression


def convert_history(columns, scales, dimension):
    """Converts the columns of a history in place."""
    for column, values in columns.items():
        if quantity := column_quantity(column):
            columns[column] = values * factor(scales, quantity, dimension)
