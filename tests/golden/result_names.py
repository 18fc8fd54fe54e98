#!/usr/bin/python3
"""The names in the results of golden scenes: columns of history.csv and keys of summary.json. Later versions keep them.

    tests/golden/result_names.py RESULTS

prints the names in a folder of results under the folder's name, as lines of columns.txt.
"""
import pathlib
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "drivers/plot"))
from result_files import read_history, read_summary  # noqa: E402

# Below these keys a run has the phases that took time and the warnings that it gave: they depend on its solver.
FREE = {"seconds", "warnings"}


def keys(entry, path=""):
    """Yields the paths of all keys of a dictionary and of the dictionaries in it."""
    for key, value in entry.items():
        yield path + key
        if isinstance(value, dict) and path + key not in FREE:
            yield from keys(value, path + key + "/")


def result_names(results):
    """Returns the names in a folder of results, by file."""
    return {"history.csv": list(read_history(results / "history.csv")),
            "summary.json": list(keys(read_summary(results / "summary.json")))}


def names_text(scene, names):
    """Returns the lines of columns.txt for a scene."""
    return "".join(textwrap.fill(f"{scene} {file}: " + ", ".join(entries), 120, subsequent_indent="  ",
                                 break_on_hyphens=False) + "\n" for file, entries in names.items())


def read_names(path):
    """Returns the names in columns.txt by scene and file."""
    result = {}
    for line in path.read_text(encoding="utf-8").replace("\n  ", " ").splitlines():
        if not line.startswith("#"):
            place, names = line.split(": ", 1)
            scene, file = place.rsplit(" ", 1)
            result.setdefault(scene, {})[file] = names.split(", ")
    return result


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    print(names_text(folder.name, result_names(folder)), end="")
