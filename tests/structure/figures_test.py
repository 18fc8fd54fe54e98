#!/usr/bin/python3
"""Checks that the measured tables of the documents are those of their data (docs/measure).

    tests/structure/figures_test.py

Each place of a table in a page must have a table of docs/figures/tables and data in docs/results/data, and must be what
the data give. Each table and each data file must have a place. Prints the tables that should be measured anew, because
their code has changed since or they were only tried: they are no error, but for TRIALS_FAIL.
"""
import pathlib
import sys

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
from figures import page, record  # noqa: E402  pylint: disable=wrong-import-position
from figures.table import all_tables  # noqa: E402  pylint: disable=wrong-import-position

TRIALS_FAIL = False  # whether a table with the numbers of a short trial is an error: no release has one


def page_problems(name, tables, placed):
    """Yields a message for each table of a page that is wrong. Adds the tables of the page to `placed`."""
    try:
        text = page.read(name)
        new = page.rendered(name, text, tables)
    except page.PageError as error:
        yield str(error)
        return
    for old, made in zip(page.PLACE.finditer(text), page.PLACE.finditer(new)):
        table = tables[old[1]]
        placed.add(table.name)
        data = record.read(table.name)
        if table.page != name:
            yield f"{name}: the table {table.name} belongs to {table.page}"
        elif data is None:
            yield f"{name}: the table {table.name} has no data: {record.command_of(table.name)}"
        elif data["columns"] != [column.key for column in table.columns]:
            yield f"{name}: the data of {table.name} have other columns: {record.command_of(table.name)}"
        elif old[3] != made[3]:
            yield f"{name}: the table {table.name} differs from its data: docs/measure --render"


def table_problems(tables, placed):
    """Yields a message for each table without a place, that takes long, or whose code does not exist, and for data
    without a table."""
    for table in tables.values():
        if table.name not in placed:
            yield f"{table.page}: it has no place for the table {table.name}"
        if table.minutes > 5 and not table.why:
            yield f"the table {table.name} takes {table.minutes} minutes: say why, or measure less"
        for code in table.code:
            if not (ROOT / code).exists():
                yield f"the table {table.name} depends on {code}, which does not exist"
    for path in sorted(record.FOLDER.glob("*")):
        if path.suffix != ".json" or path.stem not in tables:
            yield f"{path.relative_to(ROOT)} belongs to no table: delete it"


def main():
    tables, placed = all_tables(), set()
    problems = [problem for name in page.pages() for problem in page_problems(name, tables, placed)]
    problems += table_problems(tables, placed)
    for table in tables.values():
        state = record.state(table, record.read(table.name))
        if state:
            print(f"to be measured anew: {table.name}: {state}")
            if TRIALS_FAIL and state == record.TRIAL:
                problems.append(f"{table.page}: the table {table.name} is {state}: {record.command_of(table.name)}")
    if problems:
        sys.exit("\n".join(problems))
    print(f"{len(placed)} tables are those of their data")


if __name__ == "__main__":
    main()
