#!/usr/bin/python3
"""Draws the numbers of a scan over the parameter that it varies, one panel for each number."""
import csv
import itertools
import json
import math
import pathlib

import options
import style
from results import ResultsError
from study import plain, save
from style import plt

EPILOG = """Examples:
  scan.py pillar-scan.results     -> pillar-scan.results/scan.png, .svg

The script reads scan.csv and scan.json, which ixos-study --scan writes. The first parameter is the horizontal axis; of
several, each combination of the others has a line. Runs without a value leave a gap."""

PANEL = 2.4, 4.8  # inches: height of a panel, and its width


def read(folder):
    """Returns scan.json, and the rows of scan.csv by the labels of the varied parameters."""
    try:
        asked = json.loads((folder / "scan.json").read_text(encoding="utf-8"))
        with open(folder / "scan.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        names = [varied["name"] for varied in asked["varied"]]
        return asked, {tuple(row[name] for name in names): row for row in rows}
    except FileNotFoundError as error:
        raise ResultsError(f"the file {error.filename} does not exist") from None
    except (OSError, ValueError, KeyError) as error:
        raise ResultsError(f"{folder}: {error}") from None


def number(text):
    """The number that a cell has; NaN if it has none."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def draw(asked, rows):
    """Returns the figure."""
    first, *others = asked["varied"]
    values = first["values"]
    numbers = [number(value) for value in values]
    numeric = not any(math.isnan(value) for value in numbers)
    places = numbers if numeric else range(len(values))
    height, width = PANEL
    count = len(asked["quantities"])
    figure, panels = plt.subplots(count, 1, sharex=True, squeeze=False, figsize=(width, height * count))
    for quantity, axes in zip(asked["quantities"], panels[:, 0]):
        for index, labels in enumerate(itertools.product(*(other["values"] for other in others))):
            found = [number(rows.get((value, *labels), {}).get(quantity, "")) for value in values]
            name = ", ".join(f"{other['name']} {label}" for other, label in zip(others, labels))
            axes.plot(places, found, marker="o", markersize=4, linewidth=1.1, label=plain(name),
                      color=style.COLORS[index % len(style.COLORS)], linestyle="-" if numeric else "none")
        axes.set_ylabel(plain(quantity, 30))
        axes.margins(x=0.04)
    last = panels[-1, 0]
    last.set_xlabel(plain(first["name"], 60))
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
    folder = pathlib.Path(parser.parse_args().folder)
    save(draw(*read(folder)), folder / "scan")


if __name__ == "__main__":
    options.run(main)
