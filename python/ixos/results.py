"""Results of runs as arrays."""
from __future__ import annotations

import functools
import os
import pathlib
from typing import TYPE_CHECKING

import numpy as np

from .result_files import Fields, read_history, read_summary

if TYPE_CHECKING:
    from .scene import Scene


class Results:
    """The results in a folder: history, summary, fields, scene.

    `results["time"]` is a column of the history. `history` is a structured array with a field for each column of
    history.csv; an empty cell is NaN. `summary` is summary.json as a dictionary, empty until the run ends.
    """

    def __init__(self, folder: str | os.PathLike):
        self.folder = pathlib.Path(folder)
        columns = read_history(self.folder / "history.csv")
        types = [(name, np.int64 if name == "step" else np.float64) for name in columns]
        self.history = np.empty(len(next(iter(columns.values()))), types)
        for name, values in columns.items():
            self.history[name] = values
        self.summary = read_summary(self.folder / "summary.json")

    def __getitem__(self, column: str) -> np.ndarray:
        if column not in self.history.dtype.names:
            raise KeyError(f"{self.folder / 'history.csv'} has no column \"{column}\"; it has: "
                           f"{', '.join(self.history.dtype.names)}")
        return self.history[column]

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns."""
        return self.history.dtype.names

    @functools.cached_property
    def fields(self) -> Fields:
        """The mesh and the fields of fields.e, or of its series of one file a rank. Needs netCDF4.

        `fields["displacement"]` is an array of frames x nodes x components. Raises FileError if the run wrote none.
        """
        return Fields(self.folder)

    @property
    def scene(self) -> Scene:
        """The scene of the run with every value that it used, from effective.xml, as an ixos.Scene."""
        from .scene import Scene
        return Scene(self.folder / "effective.xml")

    def __repr__(self):
        return (f"<ixos.Results: {self.folder}, {self.summary.get('status', 'no summary')}, {len(self.history)} rows, "
                f"{len(self.columns)} columns>")


def results(folder: str | os.PathLike) -> Results:
    """Returns the results in a folder. Raises FileError if there are none."""
    return Results(os.fspath(folder))
