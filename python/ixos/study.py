"""Studies: one scene, run with many settings, to compare accuracy and cost."""
from __future__ import annotations

import os
import pathlib
import shutil
from typing import Any, Callable

import numpy as np

from . import _core
from ._core import FileError, StudyFile

_WORDS = {"name", "status", "reason"}


class Study:
    """A study from its XML file. Each run is a process of its own, with the command ixos.

        done = ixos.Study("xml/ball-study.xml").run()
        print(done.recommendation)
    """

    def __init__(self, path: str | os.PathLike):
        self._file = StudyFile(os.fspath(path))

    @property
    def name(self) -> str:
        """The study's name."""
        return self._file.name

    @property
    def scene(self) -> str:
        """Path of the scene's file."""
        return self._file.scene

    @property
    def axes(self) -> dict[str, list[str]]:
        """The labels of each varied quantity, by its name."""
        return self._file.axes

    @property
    def runs(self) -> list[dict[str, Any]]:
        """Name, labels and settings of each run."""
        return self._file.runs

    def run(self, output: str | os.PathLike | None = None, driver: str | os.PathLike | None = None,
            overwrite: bool = False, observer: Callable[[dict, int, bool], Any] | None = None) -> StudyResults:
        """Carries out the runs that have no result yet, and writes study.csv and study.json.

        output: folder of the results; the file's name with .results in place of its ending if None. driver: path of the
        command ixos. overwrite: replace results of another study. observer: a function that is called after each run
        with its row, the number of finished runs, and whether the run was finished already. Returns a StudyResults.
        """
        folder = os.fspath(output) if output is not None else pathlib.Path(self._file.path).stem + ".results"
        rows, recommendation = self._file.run(folder, os.fspath(driver or find_driver()), overwrite, observer)
        return StudyResults(folder, rows, list(self.axes), recommendation)


class StudyResults:
    """The results of a study's runs: `table`, a structured array with a row for each run; `recommendation`."""

    def __init__(self, folder: str, rows: list[dict], axes: list[str], recommendation: str):
        self.folder = folder
        self.recommendation = recommendation
        names = [name for name in rows[0] if name != "labels"] if rows else []
        types: list[tuple] = [(name, object if name in _WORDS else np.float64) for name in names]
        types += [(axis, object) for axis in axes]
        self.table = np.array([tuple([row[name] for name in names] + row["labels"]) for row in rows], types)

    def __repr__(self):
        return f"<ixos.StudyResults: {self.folder}, {len(self.table)} runs: {self.recommendation}>"


def find_driver() -> str | os.PathLike:
    """Returns the command ixos: of this installation, of this build, else of the path. Raises FileError."""
    here = pathlib.Path(_core.__file__).resolve().parent
    for candidate in (here.parents[3] / "bin/ixos", here.parents[1] / "drivers/ixos"):
        if candidate.is_file():
            return candidate
    found = shutil.which("ixos")
    if found is None:
        raise FileError("the command ixos is not on the path: give its path as driver")
    return found
