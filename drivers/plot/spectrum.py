#!/usr/bin/python3
"""Draws spectral radius, period error and decay of schemes for the linear oscillator, over the step in periods."""
import csv
import pathlib
import re

import numpy as np

import options
import style
from results import ResultsError
from style import plt

EPILOG = """Examples:
  spectral_properties > spectrum.csv; spectrum.py spectrum.csv        -> spectrum.png in the working folder
  spectrum.py spectrum.csv --until 0.2 --output docs/spectrum --format png,svg

The file has the columns scheme, dt_over_T, spectral_radius, period_error and decay (fractions; empty where nothing
oscillates). Curves of one scheme with different parameters have the same colour. Curves that agree are drawn once."""

COLUMNS = ["dt_over_T", "spectral_radius", "period_error", "decay"]
DASHES = ["-", (0, (5, 2)), (0, (1.5, 1.5)), (0, (7, 2, 1.5, 2))]


def read_curves(path):
    """Pairs of names and values, a column each of COLUMNS; names of schemes that agree are together."""
    path = pathlib.Path(path)
    if not path.is_file():
        raise ResultsError(f"the file {path} does not exist")
    curves = {}
    with open(path, newline="") as file:
        reader = csv.DictReader(file)
        missing = {"scheme", *COLUMNS} - set(reader.fieldnames or [])
        if missing:
            raise ResultsError(f"{path} has no column '{sorted(missing)[0]}'")
        for row in reader:
            try:
                values = [float(row[name] or "nan") for name in COLUMNS]
            except ValueError as error:
                raise ResultsError(f"{path}, line {reader.line_num}: {error}") from None
            curves.setdefault(row["scheme"], []).append(values)
    if not curves:
        raise ResultsError(f"{path} has no rows")
    groups = []
    for name, rows in curves.items():
        values = np.array(rows)
        for names, known in groups:
            if known.shape == values.shape and np.allclose(known, values, rtol=1e-9, atol=1e-9, equal_nan=True):
                names.append(name)
                break
        else:
            groups.append(([name], values))
    return groups


def looks(groups):
    """A colour for each scheme, dashes for each of its parameters; those that agree broad, so that others show them."""
    schemes = [re.sub(r"( -?[\d.]+)+$", "", names[0]) for names, _ in groups]
    known = list(dict.fromkeys(schemes))
    return [{"color": style.COLORS[known.index(scheme) % len(style.COLORS)],
             "linestyle": DASHES[schemes[:number].count(scheme) % len(DASHES)],
             "linewidth": 1.1 if len(groups[number][0]) == 1 else 2.2} for number, scheme in enumerate(schemes)]


def draw_percent(axes, groups, column, until):
    """A column in percent up to that step; limits by what is seen."""
    seen = []
    for (_, values), look in zip(groups, looks(groups)):
        axes.plot(values[:, 0], 100 * values[:, column], **look)
        seen.extend(100 * values[(values[:, 0] <= until) & np.isfinite(values[:, column]), column])
    axes.set_xlim(0, until)
    if seen:
        margin = 0.05 * (max(seen) - min(seen) or 1)
        axes.set_ylim(min(seen) - margin, max(seen) + margin)


def explain(figure, handles, groups):
    """A legend of the schemes that stand alone, and above it one of those that agree, whose names are long."""
    above = 1.0
    for joined in (False, True):
        here = [(handle, ", ".join(names)) for handle, names in zip(handles, groups) if (len(names) > 1) == joined]
        if not here:
            continue
        style.legend(figure, *zip(*here))
        legend = figure.legends[-1]
        legend.set_bbox_to_anchor((0.5, above), transform=figure.transFigure)
        extent = legend.get_window_extent(figure.canvas.get_renderer())
        above = figure.transFigure.inverted().transform(extent)[1, 1]


def main():
    style.use_style()
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("file", metavar="CSVFILE", help="file with the output of spectral_properties")
    parser.add_argument("--until", type=options.positive, default=0.4, metavar="RATIO",
                        help="end of the axes of period error and decay, in periods (default: 0.4)")
    parser.add_argument("--output", metavar="NAME", default="spectrum",
                        help="output file, without ending (default: spectrum)")
    parser.add_figure()
    arguments = parser.parse_args()

    groups = read_curves(arguments.file)
    figure, (radius, period, decay) = plt.subplots(1, 3, figsize=(7.2, 3.1), layout="constrained")
    handles = [radius.semilogx(values[:, 0], values[:, 1], **look)[0]
               for (_, values), look in zip(groups, looks(groups))]
    steps = np.concatenate([values[:, 0] for _, values in groups])
    radius.set_xlim(steps.min(), steps.max())
    radius.set_ylim(0, 1.1)
    draw_percent(period, groups, 2, arguments.until)
    draw_percent(decay, groups, 3, arguments.until)
    for axes, label in ((radius, "spectral radius"), (period, "period error [%]"), (decay, "decay a period [%]")):
        axes.set_xlabel("step / period")
        axes.set_ylabel(label)
    explain(figure, handles, [names for names, _ in groups])
    style.save(figure, arguments.output, arguments.format)


if __name__ == "__main__":
    options.run(main)
