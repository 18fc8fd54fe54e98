"""Finds the places of tables in pages, and puts the tables there.

A place is two lines of a page, with the table between them:

    <!-- table NAME: docs/measure NAME -->
    <!-- end -->
"""
import re
import textwrap

from . import record
from .table import ROOT

PLACE = re.compile(r"^<!-- table (\S+): (.+) -->\n((?:(?!<!-- (?:table|end)).*\n)*)(<!-- end -->)?", re.MULTILINE)
WIDTH = 120


class PageError(Exception):
    """A page and the tables do not fit. The message has one line."""


def pages():
    """Returns the paths of the pages that may have tables, below the root."""
    found = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
    return sorted(str(path.relative_to(ROOT)) for path in found)


def read(page):
    """Returns the text of a page. Raises PageError if it does not exist."""
    try:
        return (ROOT / page).read_text(encoding="utf-8")
    except FileNotFoundError:
        raise PageError(f"{page} does not exist") from None


def places(page, text):
    """Returns the names of the tables that a page has places for. Raises PageError if one is damaged."""
    names = []
    for place in PLACE.finditer(text):
        name, command, end = place[1], place[2], place[4]
        if not end:
            raise PageError(f"{page}: the table {name} has no line <!-- end -->")
        if command != record.command_of(name):
            raise PageError(f"{page}: the command of the table {name} must be: {record.command_of(name)}")
        if name in names:
            raise PageError(f"{page}: the table {name} has two places")
        names.append(name)
    return names


def block(table, data):
    """Returns what stands between the two lines of a place."""
    caption = textwrap.wrap(record.caption(data), WIDTH)
    return "\n".join([*table.lines(data["rows"]), "", *caption]) + "\n"


def rendered(page, text, tables):
    """Returns the text of a page with its tables from their data. A table without data stays as it is."""
    for name in places(page, text):
        if name not in tables:
            raise PageError(f"{page}: there is no table {name} in docs/figures/tables")

    def fill(place):
        data = record.read(place[1])
        inside = place[3] if data is None else block(tables[place[1]], data)
        return f"<!-- table {place[1]}: {place[2]} -->\n{inside}{place[4]}"

    return PLACE.sub(fill, text)


def write(page, tables):
    """Renders a page. Returns whether it changed."""
    text = read(page)
    new = rendered(page, text, tables)
    if new != text:
        (ROOT / page).write_text(new, encoding="utf-8")
    return new != text
