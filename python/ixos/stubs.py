"""Type stubs of the scene's lists, made from the catalogues: python3 -m ixos.stubs lists.pyi"""
import pathlib
import sys

from . import lists
from .names import identifier

HEADER = '''"""The lists of a scene. Made from the catalogues by ixos.stubs; do not edit."""
from contextlib import AbstractContextManager
from typing import Any, Iterator, Literal, Sequence

from ._core import SceneList

def unchanged_if_refused(core: SceneList) -> AbstractContextManager[None]: ...

class List:
    _core: SceneList
    _identifiers: dict[str, str]
    def __init__(self, core: SceneList, path: Sequence[str] = ...) -> None: ...
    def __getitem__(self, key: str) -> Any: ...
    def __setitem__(self, key: str, value: Any) -> None: ...
    def __delitem__(self, key: str) -> None: ...
    def __contains__(self, key: object) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def _as_dict(self) -> dict[str, Any]: ...
'''

# A number may be a text with a unit; None gives the default back.
TYPES = {"double": "float | str | None", "int": "int | None", "bool": "bool | None", "string": "str | None",
         "Array(double)": "Sequence[float] | str | None", "Array(int)": "Sequence[int] | None",
         "Array(string)": "Sequence[str] | None"}


def _type(entry):
    if entry["type"] == "string" and entry.get("words"):
        return f"Literal[{', '.join(repr(word) for word in entry['words'])}] | None"
    return TYPES.get(entry["type"], "Any")


def _class(kind):
    """The lines of a class after those of the classes that it names."""
    lines = [line for inner in kind._classes.values() for line in _class(inner)]
    lines += ["", f"class {kind.__name__}(List):", f"    {kind.__doc__!r}"]
    for name, entry in kind._description["parameters"].items():
        lines += [f"    {identifier(name)}: {_type(entry)}",
                  f"    {getattr(kind, identifier(name)).__doc__!r}"]
    for name, inner in kind._classes.items():
        if name != "<any name>":
            lines.append(f"    {identifier(name)}: {inner.__name__}")
    if "<any name>" in kind._classes:
        inner = kind._classes["<any name>"].__name__
        lines += [f"    def __getattr__(self, name: str) -> {inner}: ...",
                  f"    def __getitem__(self, key: str) -> {inner}: ..."]
    return lines


def text():
    """Returns the stubs of the module ixos.lists."""
    return HEADER + "\n".join(_class(lists.SceneLists)) + "\n\nSceneLists = Scene\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(text(), encoding="utf-8")
