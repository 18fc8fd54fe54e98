#!/usr/bin/python3
"""Draws the numbers of a scan over the parameter that it varies, one panel for each number."""
import csv
import itertools
import json
import math
import pathlib

import options
import result_files
import style
import units
from results import ResultsError
from study import plain
from style import plt

EPILOG = """Examples:
  scan.py pillar-scan.results                      -> pillar-scan.results/scan.png, .svg
  scan.py pillar-scan.results --pdf --width 86mm   -> pillar-scan.results/scan.pdf, too

The script reads scan.csv and scan.json, which ixos-study --scan writes. The first parameter is the horizontal axis; of
several, each combination of the others has a line. Runs without a value leave a gap. Units are those of the scene."""

PANEL = 2.4, 4.8  # inches: height of a panel, and its width


def read(folder):
    """Returns scan.json, the rows of scan.csv by the labels of the varied parameters, and the names of the runs."""
    try:
        asked = json.loads((folder / "scan.json").read_text(encoding="utf-8"))
        with open(folder / "scan.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        names = [varied["name"] for varied in asked["varied"]]
        return asked, {tuple(row[name] for name in names): row for row in rows}, [row["run"] for row in rows]
    except FileNotFoundError as error:
        raise ResultsError(f"the file {error.filename} does not exist") from None
    except (OSError, ValueError, KeyError) as error:
        raise ResultsError(f"{folder}: {error}") from None


def units_of_results(folder, names):
    """The units of results by kind, as the first of these runs has them that ended; empty if none did."""
    for name in names:
        try:
            known = result_files.read_summary(folder / "runs" / name / "summary.json")["units"]
            return {kind: unit["symbol"] for kind, unit in known.items()}
        except (result_files.FileError, KeyError, TypeError, AttributeError):
            continue
    return {}


def with_unit(text, expression, width):
    """A label in lines of so many letters, and its unit in one piece."""
    unit = f"[{units.symbol(expression)}]" if expression else ""
    label = plain(text, width)
    if unit:
        label += (" " if len(label.splitlines()[-1]) + len(unit) < width else "\n") + unit
    return label


def number(text):
    """The number that a cell has; NaN if it has none."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def draw(asked, rows, known):
    """Returns the figure. `known` has the units of results."""
    first, *others = asked["varied"]
    values = first["values"]
    numbers = [number(value) for value in values]
    numeric = not any(math.isnan(value) for value in numbers)
    places = numbers if numeric else range(len(values))
    height, width = PANEL
    count = len(asked["quantities"])
    figure, panels = plt.subplots(count, 1, sharex=True, squeeze=False, figsize=(width, height * count))
    columns = asked.get("unit_columns", [""] * count)
    for quantity, column, axes in zip(asked["quantities"], columns, panels[:, 0]):
        for index, labels in enumerate(itertools.product(*(other["values"] for other in others))):
            found = [number(rows.get((value, *labels), {}).get(quantity, "")) for value in values]
            name = "\n".join(with_unit(f"{other['name']} {label}", other.get("unit"), 34)
                             for other, label in zip(others, labels))
            axes.plot(places, found, marker="o", markersize=4, linewidth=1.1, label=name,
                      color=style.COLORS[index % len(style.COLORS)], linestyle="-" if numeric else "none")
        axes.set_ylabel(with_unit(quantity, known.get(units.summary_name(column)), 30))
        axes.margins(x=0.04)
    last = panels[-1, 0]
    last.set_xlabel(with_unit(first["name"], first.get("unit"), 60))
    if first["logarithmic"] and min(numbers) > 0:
        last.set_xscale("log")
    if not numeric:
        last.set_xticks(list(places), [plain(value, 20) for value in values])
    if others:
        panels[0, 0].legend(loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False, fontsize=8)
    return figure


def main():
    style.use_style()
    plt.rcParams["svg.hashsalt"] = "scan"
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="FOLDER", help="results folder of a scan (with scan.csv and scan.json)")
    parser.add_figure()
    parser.set_defaults(format=["png", "svg"])
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.folder)
    asked, rows, runs = read(folder)
    style.save(draw(asked, rows, units_of_results(folder, runs)), folder / "scan", arguments.format)


if __name__ == "__main__":
    options.run(main)
