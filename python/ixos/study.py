"""Studies: one scene, run with many settings, to compare accuracy and cost."""
import os
import pathlib
import shutil

import numpy as np

from . import _core
from ._core import FileError, StudyFile

_WORDS = {"name", "status", "reason"}


class Study:
    """A study from its XML file. Each run is a process of its own, with the command ixos.

        done = ixos.Study("xml/ball-study.xml").run()
        print(done.recommendation)
    """

    def __init__(self, path):
        self._file = StudyFile(os.fspath(path))

    name = property(lambda self: self._file.name, doc="The study's name.")
    scene = property(lambda self: self._file.scene, doc="Path of the scene's file.")
    axes = property(lambda self: self._file.axes, doc="The labels of each varied quantity, by its name.")
    runs = property(lambda self: self._file.runs, doc="Name, labels and settings of each run.")

    def run(self, output=None, driver=None, overwrite=False, observer=None):
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

    def __init__(self, folder, rows, axes, recommendation):
        self.folder = folder
        self.recommendation = recommendation
        names = [name for name in rows[0] if name != "labels"] if rows else []
        types = [(name, object if name in _WORDS else np.float64) for name in names] + [(axis, object) for axis in axes]
        self.table = np.array([tuple([row[name] for name in names] + row["labels"]) for row in rows], types)

    def __repr__(self):
        return f"<ixos.StudyResults: {self.folder}, {len(self.table)} runs: {self.recommendation}>"


def find_driver():
    """Returns the command ixos: of this installation, of this build, else of the path. Raises FileError."""
    here = pathlib.Path(_core.__file__).resolve().parent
    for candidate in (here.parents[3] / "bin/ixos", here.parents[1] / "drivers/ixos"):
        if candidate.is_file():
            return candidate
    found = shutil.which("ixos")
    if found is None:
        raise FileError("the command ixos is not on the path: give its path as driver")
    return found
