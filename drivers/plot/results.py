"""Reads a results folder: history.csv, summary.json, the fields of fields.e (or of its series, one file a rank)."""
import csv
import json
import pathlib
import xml.etree.ElementTree

import numpy as np

# Their reactions are means over the step, so belong to its middle.
STEP_MEAN_SCHEMES = {"Gautam-Sauer Composite", "Average Vector Field", "Energy-Momentum", "Midpoint"}


class ResultsError(Exception):
    """What the user asked for is not there; one line."""


class Run:
    """history.csv as columns (NaN where a cell is empty; of `interval` in time only) and summary.json."""

    def __init__(self, folder, interval=None):
        self.folder = existing(folder)
        self.columns = read_history(self.folder / "history.csv")
        self.initial_energy = self["total_energy"][0]
        self.whole = not interval or interval[1] >= self["time"][-1]  # nothing cut off the end
        if interval:
            inside = within(self["time"], interval)
            if np.count_nonzero(inside) < 2:
                raise ResultsError(f"{self.folder / 'history.csv'} has no rows from time {interval[0]:g} to "
                                   f"{interval[1]:g}: it goes from {self['time'][0]:g} to {self['time'][-1]:g}")
            self.columns = {name: values[inside] for name, values in self.columns.items()}
        summary = self.folder / "summary.json"
        try:
            self.summary = json.loads(summary.read_text()) if summary.is_file() else {}
        except ValueError as error:
            raise ResultsError(f"{summary}: {error}") from None
        self.scheme = self.summary.get("scheme", self.folder.resolve().name)
        self.dimension = 3 if "linear_momentum_z" in self.columns else 2

    def __getitem__(self, name):
        if name not in self.columns:
            raise ResultsError(f"{self.folder / 'history.csv'} has no column '{name}'")
        return self.columns[name]

    def has(self, name):
        """Whether the column holds anything."""
        return bool(np.isfinite(self[name]).any())

    def energy_error(self):
        """|E - E0 - external work + dissipated energy|, row by row."""
        balance = self["total_energy"] - self.initial_energy
        return np.abs(balance - np.nan_to_num(self["external_work"]) + np.nan_to_num(self["dissipated_energy"]))

    def reactions(self):
        """(name, times, values) of each reaction column, at the times that the values belong to."""
        means = self.scheme in STEP_MEAN_SCHEMES
        time = self["time"] - 0.5 * self["time_step"] if means else self["time"]
        first = int(means and self["step"][0] == 0)
        return [(name, time[first:], values[first:]) for name, values in self.columns.items()
                if name.startswith("reaction_")]


def within(times, interval):
    """Which times lie in the interval, up to round-off."""
    slack = 1e-9 * (interval[1] - interval[0])
    return (times >= interval[0] - slack) & (times <= interval[1] + slack)


def existing(folder):
    """The folder as a path, when it is one."""
    folder = pathlib.Path(folder)
    if not folder.is_dir():
        raise ResultsError(f"there is no folder {folder}")
    return folder


def read_history(path):
    """Columns of history.csv by name. A last row cut short (the run was killed, or still writes) is left out."""
    if not path.is_file():
        raise ResultsError(f"there is no file {path}")
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    names, rows = (rows[0], rows[1:]) if rows else ([], [])
    if rows and len(rows[-1]) != len(names):
        rows.pop()
    if not rows:
        raise ResultsError(f"{path} has no rows")
    try:
        values = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows])
        return dict(zip(names, values.reshape(len(rows), len(names)).T))
    except ValueError as error:
        raise ResultsError(f"{path}: {error}") from None


def labels(runs):
    """A label for each run: its scheme, or its folder's name where two agree."""
    schemes = [run.scheme for run in runs]
    return [run.scheme if schemes.count(run.scheme) == 1 else run.folder.resolve().name for run in runs]


def wall_height(folder):
    """Height of the scene's flat wall by effective.xml: 0 where that is not known, None where there is no such wall."""
    path = pathlib.Path(folder) / "effective.xml"
    if not path.is_file():
        return 0.0
    try:
        interactions = xml.etree.ElementTree.parse(path).find("ParameterList[@name='Interactions']")
        for interaction in [] if interactions is None else interactions.findall("ParameterList"):
            value = {entry.get("name"): entry.get("value") for entry in interaction.findall("Parameter")}
            normal, point = ([float(word) for word in value.get(name, "{}").strip("{} ").split(",") if word]
                             for name in ("Normal", "Point"))
            if not any(normal[:-1]):
                return point[-1] if point else 0.0
    except (xml.etree.ElementTree.ParseError, ValueError) as error:
        raise ResultsError(f"{path}: {error}") from None
    return None
