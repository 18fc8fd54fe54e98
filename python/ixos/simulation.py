"""The members of Simulation and RunResult that are written in Python."""
import os
import sys
import warnings

from ._core import RunResult, Simulation


class SceneWarning(UserWarning):
    """Something in a scene or in its run that is allowed, but may be a mistake."""


def report(simulation, messages):
    """Issues warnings on the first rank, at the user's line."""
    if simulation.rank != 0 or not messages:
        return
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for message in messages:
        warnings.warn(message, SceneWarning, stacklevel=level)


def run(self, output, overwrite=False, restart=None, observer=None, log=None, progress=None):
    """Runs from the present state to the scene's Final Time, with results in the folder `output`.

    Issues SceneWarning if the run did not reach its end: its results up to there are in the folder. An exception of an
    observer, and Ctrl-C, end the run on all ranks with a checkpoint. For the arguments see Scene.run().
    """
    if observer is not None:
        self.observers.append(observer)
    try:
        folder = os.fspath(output)
        result = self._run(folder, overwrite, os.fspath(restart or ""), log, progress)
    finally:
        if observer in self.observers:  # it may have removed itself
            self.observers.remove(observer)
    result.folder = folder
    report(self, result.warnings + result.findings)
    if result.status in ("diverged", "interrupted"):
        report(self, [f"the run ended at t = {result.end_time:.6g} T0, after {result.steps} steps: {result.reason}. "
                      f"Results up to there are in {folder}"])
    return result


def results_of(self):
    """The results in the run's folder, as ixos.results() returns them."""
    from .results import results
    return results(self.folder)


def parameters(self):
    """The complete scene in plain numbers, as an ixos.Scene."""
    from .scene import Scene
    return Scene(self._parameters)


Simulation.run = run
Simulation.parameters = property(parameters)
RunResult.results = property(results_of)
