"""Scans: numbers that the runs of a scene yield, over varied parameters."""
from __future__ import annotations

import os
import pathlib
import warnings
from typing import Any, Callable, Iterable, Mapping

import numpy as np

from . import _core
from ._core import InputError
from .study import find_driver


def scan(scene: str | os.PathLike, vary: Mapping[str, str | Iterable], collect: str | Iterable[str] = (),
         set: str | Iterable[str] = (),  # pylint: disable=redefined-builtin
         output: str | os.PathLike | None = None, jobs: int = 1, driver: str | os.PathLike | None = None,
         overwrite: bool = False, observer: Callable[[dict, int, bool], Any] | None = None) -> np.ndarray:
    """Runs a scene's file for all combinations of varied parameters, each run a process of the command ixos.

        table = ixos.scan("pillar.xml", {"Materials/Polymer/Young's Modulus": "0.5:2:4:log"}, "peak reaction_top_y")
        plt.plot(table["Young's Modulus"], table["peak reaction_top_y"])

    vary: by a parameter's path "from:to:number", the same with ":log" for equal ratios, or the values. collect: numbers
    such as "peak reaction_top_y"; Output/Quantities of the scene if there are none. set: changes of the scene,
    "List/Name=value". output: folder of scan.csv and of the runs; the scene's name with -scan.results if None. jobs:
    runs at the same time. Runs that the folder has are not repeated. observer: a function that is called after each run
    with its row, the number of finished runs, and whether the run was finished already. Returns a structured array with
    a row for each run: the varied parameters by their names, the numbers, NaN where a run has none, and name, status,
    reason, wall_seconds and steps.
    """
    def words(given):
        return [given] if isinstance(given, str) else [str(word) for word in given]

    def text(values):
        return values if isinstance(values, str) else "{" + ", ".join(str(value) for value in values) + "}"

    if not isinstance(scene, (str, os.PathLike)):
        raise InputError("scan: the runs read a scene's file; write the scene, scene.write(path), and give that path")
    numbers = words(collect)
    for number in numbers:
        if numbers.count(number) > 1 or number in _REST or number in [path.rpartition("/")[2] for path in vary]:
            raise InputError(f"collect: two columns would have the name \"{number}\"")
    if jobs > (os.cpu_count() or jobs):
        warnings.warn(f"{jobs} jobs share {os.cpu_count()} processors: each run takes longer", stacklevel=2)
    folder = os.fspath(output) if output is not None else pathlib.Path(scene).stem + "-scan.results"
    names, quantities, rows = _core.scan(
        os.fspath(scene), [f"{path}={text(values)}" for path, values in vary.items()], numbers, words(set), folder,
        os.fspath(driver or find_driver()), jobs, overwrite, observer)
    table = [tuple([_value(label) for label in row["labels"]] + row["values"] + [row[name] for name in _REST])
             for row in rows]
    numeric = [all(isinstance(row[i], float) for row in table) for i in range(len(names))]
    types = [(name, np.float64 if number else object) for name, number in zip(names, numeric)]
    types += [(quantity, np.float64) for quantity in quantities]
    types += [(name, kind) for name, kind in _REST.items()]
    return np.array(table, types)


_REST = {"name": object, "status": object, "reason": object, "wall_seconds": np.float64, "steps": np.int64}


def _value(label):
    """The number that a label is, or the label."""
    try:
        return float(label)
    except ValueError:
        return label
