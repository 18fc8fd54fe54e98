"""Ixos: dynamic adhesion of deformable bodies.

    import ixos
    ixos.Scene("strip.xml").run()                 # as the command ixos does
    simulation = ixos.Scene("strip.xml").simulation()
    simulation.step(0.1)                          # or step by step, with u, v, a as NumPy arrays

Scene: what a run computes. Simulation: a scene at some time. Mesh: a mesh from arrays. results(): a run's results.
scan(): a number over varied parameters. Study: many runs. On several ranks, run the script with mpirun; MPI starts with
the import.
"""
try:
    from ._core import FileError, InputError, Mesh, Progress, RunResult, Simulation, StepResult, __version__
except ModuleNotFoundError as error:
    if error.name != "ixos._core":
        raise
    from .missing_core import explanation
    raise ImportError(explanation(), name=error.name) from None
from .result_files import Fields
from .results import Results, results
from .scan import scan
from .scene import Scene
from .simulation import SceneWarning
from .study import Study, StudyResults

__all__ = ["Fields", "FileError", "InputError", "Mesh", "Progress", "Results", "RunResult", "Scene", "SceneWarning",
           "Simulation", "StepResult", "Study", "StudyResults", "__version__", "results", "scan"]
