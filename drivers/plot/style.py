"""One look for all pictures: colours, fonts, labels, the wall, saving."""
import csv
import math
import pathlib
import typing
import warnings

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of the backend)
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from matplotlib.colors import ListedColormap  # noqa: E402

import units  # noqa: E402
from scene_file import ResultsError  # noqa: E402

# Okabe and Ito's colours, told apart by all eyes, the strongest first.
COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#6A3D9A", "#8C510A", "#8A8A8A"]
INK, FAINT = "#303030", "#D9D9D9"
DPI, PAD = 200, 0.06  # pixels an inch; inches around a figure
DATA = "-data.csv"  # ends the names of tables: history.csv is the run's

FIELD_LABELS = {
    "first_stress_invariant": "first stress invariant /\nYoung's modulus",
    "jacobian": "volume ratio",
}

# The value of a field at rest, and what differs less from it is rounding: both fields have no unit.
NOISE = {"first_stress_invariant": (0.0, 1e-9), "jacobian": (1.0, 1e-9)}


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
        "legend.frameon": False, "figure.dpi": 100, "savefig.dpi": DPI, "svg.fonttype": "none",
        "pdf.fonttype": 42, "ps.fonttype": 42, "hatch.linewidth": 0.5,
    })


def unit(quantity, dimension):
    """The unit of a quantity, ready for a label; forces and energies of plane bodies are per depth."""
    return f"[{units.name(quantity, dimension)}]"


def field_label(field):
    """The label of an element field."""
    if field in FIELD_LABELS:
        return FIELD_LABELS[field]
    quantity = units.field_quantity(field)
    return field.replace("_", " ") + (f" {unit(quantity, 2)}" if quantity else "")


def is_noise(field, values):
    """Whether values differ from those at rest by rounding only."""
    rest, floor = NOISE.get(field, (None, 0.0))
    if rest is None:
        rest, floor = float(np.mean(values)), 1e-12 * float(np.nanmax(np.abs(values)))
    return bool(np.nanmax(np.abs(values - rest)) <= floor)


def color_scale(field, values, limits=None):
    """The colour map of an element field and its limits: stress diverges about zero, other fields are sequential.

    Zero stress stays white, and shades mean the same on both sides of it, where limits are not even about it. Without
    limits, rounding errors are drawn in one colour."""
    low, high = limits or (float(np.nanmin(values)), float(np.nanmax(values)))
    if limits is None and is_noise(field, values):
        rest, floor = NOISE.get(field, (0.5 * (low + high), 1e-9 * (abs(low) or 1)))
        low, high = rest - 1e3 * floor, rest + 1e3 * floor
    if "stress" in field and limits is None:
        high = max(abs(low), abs(high))
        low = -high
    if not high > low:
        low, high = low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1)
    if "stress" not in field:
        return "YlGnBu", plt.Normalize(low, high)
    bound = max(abs(low), abs(high))
    shades = plt.get_cmap("RdBu_r", 1024)(np.linspace(0.5 + 0.5 * low / bound, 0.5 + 0.5 * high / bound, 256))
    return ("RdBu_r" if low == -high else ListedColormap(shades)), plt.Normalize(low, high)


def legend(figure, handles, names, title=None):
    """A legend above the figure, in as few rows as its width permits."""
    for rows in range(1, len(names) + 1):
        columns = [names[first:first + rows] for first in range(0, len(names), rows)]
        if sum(max(map(len, column)) + 7 for column in columns) <= 14 * figure.get_figwidth():
            break
    figure.legend(handles, names, title=title, ncol=len(columns), loc="lower center", bbox_to_anchor=(0.5, 1),
                  borderaxespad=0.2, handlelength=2.2, title_fontproperties={"weight": "bold"})


def draw_wall(axes, wall):
    """A rigid wall across the axes: a line and a hatched area behind it, drawn within the present limits. wall: its
    height, or a point and the normal towards the body."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    point, normal = wall if isinstance(wall, tuple) else (np.array([0.0, wall]), np.array([0.0, 1.0]))
    corners = np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
    behind, line = [], []
    for start, end in zip(corners, np.roll(corners, -1, axis=0)):
        here, there = (start - point) @ normal, (end - point) @ normal
        if here <= 0:
            behind.append(start)
        if here * there < 0:
            line.append(start + (end - start) * here / (here - there))
            behind.append(line[-1])
    if len(behind) > 2:
        axes.fill(*np.array(behind).T, facecolor="none", hatch="/////", edgecolor="#8C8C8C", linewidth=0)
    if len(line) == 2:
        axes.plot(*np.array(line).T, color=INK, linewidth=0.9)


def box(points, wall):
    """Limits (left, right), (bottom, top) around `points` (any shape, last axis x, y) and the wall, with a margin."""
    flat = points.reshape(-1, points.shape[-1])
    low, high = flat.min(axis=0), flat.max(axis=0)
    margin = 0.06 * float((high - low).max() or 1)
    low, high = low - margin, high + margin
    if wall is not None and not isinstance(wall, tuple):
        low[1], high[1] = min(low[1], wall - margin), max(high[1], wall + margin)
    return (low[0], high[0]), (low[1], high[1])


class Output(typing.NamedTuple):
    """How figures are written."""
    dpi: int
    width: float | None = None  # inches; None: as the script draws it
    data: bool = False  # whether the points of all lines are written, too


output = Output(DPI)


def has_room(figure):
    """Lays a figure out. Returns whether its panels have room beside its text."""
    with warnings.catch_warnings():
        warnings.filterwarnings("error", ".*collapsed to zero.*", UserWarning)
        try:
            figure.draw_without_rendering()
        except UserWarning:
            return False
    return True


def whole_width(figure):
    """The width of a figure that is laid out in inches, margins included."""
    return figure.get_tightbbox(figure.canvas.get_renderer()).width + 2 * PAD


def fits(figure, width):
    """Gives the figure a width in inches, margins included. Returns whether it has room then."""
    for _ in range(8):
        if not has_room(figure):
            return False
        own, height = figure.get_size_inches()
        figure.set_size_inches(max(own + width - whole_width(figure), 0.3 * width), height)
    return True


def fit_width(figure, width):
    """Gives the figure a width in inches, margins included. Text keeps its size."""
    size, step, most = figure.get_size_inches(), 5 / 25.4, 4 * figure.get_size_inches()[0]
    if fits(figure, width):
        return
    least = width
    while least < most:
        least += step
        figure.set_size_inches(size)
        if fits(figure, least):
            break
    raise ResultsError(f"a width of {25.4 * width:.0f} mm is too narrow for this figure, whose text keeps its size; choose "
                       f"at least {math.ceil(25.4 * least)} mm")


def write_lines(figure, target):
    """Writes the points of all lines as a table: panel, line, x, y. A deformed mesh is a line `cells` of the middles of
    its cells, with their value; bodies in space are pictures and have none."""
    with open(target, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        bodies = {axes: [own for own in axes.collections if own.get_array() is not None and isinstance(own, PolyCollection)]
                  for axes in figure.axes}
        has_cells = any(bodies.values())
        table.writerow(["panel", "line", "x", "y", *(["value"] if has_cells else [])])
        for number, axes in enumerate(figure.axes, 1):
            panel = " ".join((axes.get_ylabel() or axes.get_title() or f"panel {number}").split())
            for count, line in enumerate(axes.lines, 1):
                label = line.get_label()
                label = f"line {count}" if label.startswith("_") else " ".join(label.split())
                table.writerows([panel, label, float(x), float(y), *([""] if has_cells else [])]
                                for x, y in zip(line.get_xdata(), line.get_ydata()))
            for body in bodies[axes]:
                middles = [path.vertices[:-1].mean(axis=0) for path in body.get_paths()]
                table.writerows([axes.get_title() or panel, "cells", float(x), float(y), float(value)]
                                for (x, y), value in zip(middles, body.get_array()))


def save(figure, name, formats):
    """Saves name.png, name.svg, ... and prints what was written; an ending in `name` is the only format."""
    path = pathlib.Path(name)
    if path.suffix in (".png", ".svg", ".pdf", ".eps"):
        path, formats = path.with_suffix(""), [path.suffix[1:]]
    if output.width:
        fit_width(figure, output.width)
    for ending in [*(f".{kind}" for kind in formats), *([DATA] if output.data else [])]:
        target = path.parent / f"{path.name}{ending}"
        try:
            if ending == DATA:
                write_lines(figure, target)
            else:
                figure.savefig(target, bbox_inches="tight", pad_inches=PAD, dpi=output.dpi)
        except OSError as error:
            raise ResultsError(f"{target} cannot be written: {error.strerror}") from None
        print(target)
