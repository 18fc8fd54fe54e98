"""Says what a measured table is, and finds all tables of docs/figures/tables."""
import dataclasses
import importlib
import math
import pathlib
import pkgutil
from typing import Callable

ROOT = pathlib.Path(__file__).resolve().parents[2]
MISSING = "-"


@dataclasses.dataclass(frozen=True)
class Column:
    """A column: its head, the format of its numbers, and the key of its values in the rows (by default the head)."""
    title: str
    form: str = "{}"
    key: str = ""

    def __post_init__(self):
        if not self.key:
            object.__setattr__(self, "key", self.title)

    def cell(self, row):
        """Returns the text of this column in a row. A text stands as it is, for a value that is missing a dash."""
        value = row.get(self.key)
        if value is None or isinstance(value, float) and not math.isfinite(value):
            return MISSING
        return value if isinstance(value, str) else self.form.format(value)


@dataclasses.dataclass(frozen=True)
class Table:
    """A table: where it stands, and how it is measured.

    page: path of the page below the root. measure: takes a Context (runs.py) and returns the rows, each a dictionary of
    raw numbers and texts by the keys of the columns. code: files and folders on which the numbers depend, besides the
    module of `measure` and the scenes and scripts that it runs. needs: CMake targets that `measure` runs, besides ixos
    and ixos-study. presets: further presets of CMake whose ixos `measure` runs, unless in a trial; they are built, like
    the targets, before the time is taken. picture: path of a script that draws the data of this table. minutes:
    estimate on an idle machine of two cores. why: says why the table takes more than five minutes.
    """
    name: str
    page: str
    columns: list
    measure: Callable
    code: tuple
    needs: tuple = ()
    presets: tuple = ()
    picture: str = ""
    minutes: float = 1
    why: str = ""

    def lines(self, rows):
        """Returns the lines of the table in Markdown."""
        lines = [[column.title for column in self.columns], ["---"] * len(self.columns)]
        lines += [[column.cell(row) for column in self.columns] for row in rows]
        return ["| " + " | ".join(cells) + " |" for cells in lines]


def all_tables():
    """Returns all tables by name."""
    from . import tables  # pylint: disable=import-outside-toplevel
    found = {}
    for module in sorted(module.name for module in pkgutil.iter_modules(tables.__path__)):
        for table in importlib.import_module(f"{tables.__name__}.{module}").TABLES:
            if table.name in found:
                raise ValueError(f"two tables have the name {table.name}")
            found[table.name] = table
    return found
