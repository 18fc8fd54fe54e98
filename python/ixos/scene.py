"""Scenes: what a run computes."""
from __future__ import annotations

import os
import pathlib
from typing import Any, Callable

from . import _core
from .lists import SceneLists, unchanged_if_refused
from .simulation import report


class Scene(SceneLists):
    """A scene: from an XML file, from dictionaries of its lists, or empty.

        scene = ixos.Scene("strip.xml")
        scene.materials["Strip"].youngs_modulus = "2 MPa"
        scene["Time Integrator/Time Step Control/Final Time"] = 40
        scene.run()

    Completion shows the lists and parameters that a scene may have; help(type(scene.output)) explains them. Ixos
    refuses bad input with ixos.InputError, whose text is the one that the command ixos prints.
    """

    def __init__(self, source: str | os.PathLike | dict | None = None, name: str | None = None):
        if isinstance(source, _core.SceneList):
            core = source
        elif source is None or isinstance(source, dict):
            core = _core.SceneList(name or "Scene")
        else:
            core = _core.SceneList.read(os.fspath(source))
        super().__init__(core)
        if isinstance(source, dict):
            for key, value in source.items():
                self[self._identifiers.get(key, key)] = value

    @classmethod
    def template(cls, name: str) -> Scene:
        """Returns a complete scene with every parameter that it uses: "ball" or "block"."""
        return cls(_core.SceneList.template(name))

    @classmethod
    def parse(cls, xml: str, origin: str = "scene") -> Scene:
        """Returns a scene from the text of an XML file; messages name it `origin`."""
        return cls(_core.SceneList.parse(xml, origin))

    def copy(self) -> Scene:
        """Returns an independent copy."""
        return Scene(self._core.copy())

    __copy__ = copy

    def __deepcopy__(self, memo: dict) -> Scene:
        return self.copy()

    def set(self, *assignments: str) -> Scene:
        """Carries out "List/Sublist/Name=value" as the command's --set does. Returns the scene."""
        with unchanged_if_refused(self._core):
            for assignment in assignments:
                self._core.set(assignment)
        return self

    def complete(self) -> Scene:
        """Returns the scene in plain numbers with every default filled in. Raises InputError."""
        return Scene(self._core.complete())

    def as_dict(self) -> dict:
        """Returns what the scene gives, as dictionaries of names in XML."""
        return self._as_dict()

    def xml(self) -> str:
        """Returns the scene as XML."""
        return self._core.text()

    def write(self, path: str | os.PathLike) -> None:
        """Writes the scene to an XML file."""
        self._core.write(os.fspath(path))

    def mesh_arrays(self) -> _core.Mesh:
        """Returns the scene's mesh as an ixos.Mesh, before any enrichment of its surfaces."""
        return _core.Mesh.of(self._core)

    def simulation(self, comm: Any = None, mesh: _core.Mesh | None = None) -> _core.Simulation:
        """Returns the scene as an ixos.Simulation at its initial state, for steps.

        comm: a communicator of mpi4py; all ranks of MPI if None. mesh: an ixos.Mesh, the same on all ranks, in place of
        the scene's. Issues the scene's warnings as ixos.SceneWarning, on the first rank.
        """
        simulation = _core.Simulation(self._core, comm, mesh)
        report(simulation, simulation.warnings)
        return simulation

    def run(self, output: str | os.PathLike | None = None, overwrite: bool = False,
            restart: str | os.PathLike | None = None, observer: Callable[[_core.Simulation], Any] | None = None,
            comm: Any = None, mesh: _core.Mesh | None = None,
            log: Callable[[str], Any] | None = None,
            progress: Callable[[_core.Progress], Any] | None = None) -> _core.RunResult:
        """Runs the scene to its end, as the command ixos does. Returns an ixos.RunResult.

        output: folder of the results; the scene file's name without its ending, with .results, if None. overwrite:
        replace results of another scene. restart: a checkpoint, or a folder with checkpoints, to resume from.
        observer: a function that is called with the simulation after each accepted step. log: a function that is
        called with lines for a person, such as print. progress: a function that is called on the first rank with an
        ixos.Progress, after each step and at each iterate of Newton's method. For comm and mesh see simulation().
        """
        if output is None:
            if not self._core.file:
                raise ValueError("output: a scene without a file needs a folder for its results")
            output = pathlib.Path(self._core.file).stem + ".results"
        simulation = self.simulation(comm, mesh)
        return simulation.run(output, overwrite=overwrite, restart=restart, observer=observer, log=log,
                              progress=progress)
