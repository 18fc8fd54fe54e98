"""Results of runs as arrays."""
import csv
import json
import os
import pathlib

import numpy as np

from ._core import FileError
from .scene import Scene


class Results:
    """The results in a folder: history, summary, scene.

    `results["time"]` is a column of the history. `history` is a structured array with a field for each column of
    history.csv; an empty cell is NaN. `summary` is summary.json as a dictionary.
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.history = read_history(self.folder / "history.csv")
        self.summary = read_summary(self.folder / "summary.json")

    def __getitem__(self, column: str) -> np.ndarray:
        if column not in self.history.dtype.names:
            raise KeyError(f"{self.folder / 'history.csv'} has no column \"{column}\"; it has: "
                           f"{', '.join(self.history.dtype.names)}")
        return self.history[column]

    @property
    def columns(self) -> tuple:
        """The names of the columns."""
        return self.history.dtype.names

    @property
    def scene(self) -> Scene:
        """The scene of the run with every value that it used, from effective.xml."""
        return Scene(self.folder / "effective.xml")

    @property
    def fields(self):
        """The path of fields.e, for netCDF4 or ParaView; None if the run wrote none."""
        path = self.folder / "fields.e"
        return path if path.exists() else None

    def __repr__(self):
        return (f"<ixos.Results: {self.folder}, {self.summary.get('status', 'no summary')}, {len(self.history)} rows, "
                f"{len(self.columns)} columns>")


def results(folder) -> Results:
    """Returns the results in a folder. Raises FileError if there are none."""
    return Results(os.fspath(folder))


def read_history(path) -> np.ndarray:
    """Returns history.csv as a structured array. Leaves out a last row that is cut short: the run may still write."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    if not rows:
        raise FileError(f"{path}: the file is empty")
    names, rows = rows[0], rows[1:]
    if rows and len(rows[-1]) != len(names):
        rows.pop()
    history = np.empty(len(rows), [(name, np.int64 if name == "step" else np.float64) for name in names])
    try:
        values = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows])
        values = values.reshape(len(rows), len(names))
    except ValueError as error:
        raise FileError(f"{path}: {error}") from None
    for column, name in enumerate(names):
        history[name] = values[:, column]
    return history


def read_summary(path) -> dict:
    """Returns summary.json; an empty dictionary if the run has not ended."""
    try:
        return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    except ValueError as error:
        raise FileError(f"{path}: {error}") from None
