"""One look and one command line for all pictures: colours, fonts, labels, saving, errors on one line."""
import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of the backend)
import numpy as np  # noqa: E402

from results import ResultsError  # noqa: E402

# Okabe and Ito's colours, told apart by all eyes, the strongest first.
COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
INK, FAINT = "#303030", "#D9D9D9"

FIELD_LABELS = {
    "first_stress_invariant": "first stress invariant / Young's modulus",
    "jacobian": "volume ratio",
    "energy_density": "energy density [E₀]",
}


def use_style():
    """Sets matplotlib's defaults; every script calls it once."""
    plt.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 9, "mathtext.fontset": "dejavusans",
        "axes.labelsize": 9, "axes.titlesize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8.5,
        "axes.linewidth": 0.6, "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK,
        "xtick.color": INK, "ytick.color": INK, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
        "xtick.minor.width": 0.4, "ytick.minor.width": 0.4, "xtick.direction": "in", "ytick.direction": "in",
        "axes.spines.top": False, "axes.spines.right": False,
        "axes.grid": True, "grid.color": FAINT, "grid.linewidth": 0.4, "axes.axisbelow": True,
        "axes.prop_cycle": plt.cycler(color=COLORS), "lines.linewidth": 0.9, "lines.solid_capstyle": "round",
        "legend.frameon": False, "figure.dpi": 100, "savefig.dpi": 200, "svg.fonttype": "none", "hatch.linewidth": 0.5,
    })


def unit(quantity, dimension):
    """The unit of a quantity, ready for a label; plane bodies are counted a unit of thickness."""
    powers = {"energy": dimension, "force": dimension - 1}
    if quantity == "time":
        return "[T₀]"
    return "[L₀]" if quantity == "length" else "[E₀ L₀" + ["", "", "²", "³"][powers[quantity]] + "]"


def color_scale(field, values, limits=None):
    """The colour map of an element field and its limits: stress diverges about zero, other fields are sequential."""
    low, high = limits or (float(np.nanmin(values)), float(np.nanmax(values)))
    if "stress" in field and limits is None:
        high = max(abs(low), abs(high))
        low = -high
    if not high > low:
        low, high = low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1)
    return ("RdBu_r" if "stress" in field else "cividis"), plt.Normalize(low, high)


def draw_wall(axes, height):
    """A rigid wall below `height` across the axes: a line and a hatched band, drawn within the present limits."""
    left, right = axes.get_xlim()
    bottom = axes.get_ylim()[0]
    axes.fill_between([left, right], bottom, height, facecolor="none", hatch="/////", edgecolor="#8C8C8C", linewidth=0)
    axes.plot([left, right], [height, height], color=INK, linewidth=0.9)


def box(points, wall):
    """Limits (left, right), (bottom, top) around `points` (any shape, last axis x, y) and the wall, with a margin."""
    flat = points.reshape(-1, points.shape[-1])
    low, high = flat.min(axis=0), flat.max(axis=0)
    margin = 0.06 * float((high - low).max() or 1)
    low, high = low - margin, high + margin
    if wall is not None:
        low[1], high[1] = min(low[1], wall - margin), max(high[1], wall + margin)
    return (low[0], high[0]), (low[1], high[1])


def save(figure, name, formats):
    """Saves name.png, name.svg, ... and prints what was written; an ending in `name` is the only format."""
    path = pathlib.Path(name)
    if path.suffix in (".png", ".svg"):
        path, formats = path.with_suffix(""), [path.suffix[1:]]
    for ending in formats:
        target = path.parent / f"{path.name}.{ending}"
        try:
            figure.savefig(target, bbox_inches="tight", pad_inches=0.06)
        except OSError as error:
            raise ResultsError(f"{target} cannot be written: {error.strerror}") from None
        print(target)


def formats(text):
    """The type of --format."""
    words = text.split(",")
    for word in words:
        if word not in ("png", "svg"):
            raise argparse.ArgumentTypeError(f"unknown format '{word}': png, svg or png,svg")
    return words


def scale(text):
    """The type of --relative: 'initial' or a number above zero."""
    try:
        if text == "initial" or float(text) > 0:
            return text if text == "initial" else float(text)
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"'{text}' is neither initial nor a number above zero")


def numbers(text):
    """The type of options that take numbers separated by commas."""
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no list of numbers like 0,0.5,1") from None
    return values


def count(text):
    """The type of options that take a whole number above zero."""
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number above zero")
    return int(text)


def interval(text):
    """The type of options that take two rising numbers."""
    values = numbers(text)
    if len(values) != 2 or not values[1] > values[0]:
        raise argparse.ArgumentTypeError(f"'{text}' is no interval like 0,0.5")
    return values


class Parser(argparse.ArgumentParser):
    """A parser whose complaints take one line."""

    def __init__(self, description, epilog):
        super().__init__(description=description, epilog=epilog, formatter_class=argparse.RawDescriptionHelpFormatter)

    def error(self, message):
        self.exit(2, f"{self.prog}: {message} (try --help)\n")


def run(main):
    """Runs a script: a ResultsError becomes one line and exit status 2."""
    try:
        use_style()
        main()
    except ResultsError as error:
        print(f"{pathlib.Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        sys.exit(2)
