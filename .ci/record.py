"""The record of the slices that passed, .ci/record.csv: a line for each, in the order in which they were added."""
import csv
import os
import pathlib
import re
from typing import NamedTuple

FILE = pathlib.Path(__file__).resolve().parent / "record.csv"


class Entry(NamedTuple):
    """When a slice passed. `machine` says in words where."""
    slice: str
    date: str
    commit: str
    minutes: str
    machine: str
    result: str


def read(lines):
    """Returns the entries of the record's lines. Throws ValueError if one is not sound."""
    rows = list(csv.reader(lines))
    if not rows or tuple(rows[0]) != Entry._fields:
        raise ValueError("record.csv: its first line must be " + ",".join(Entry._fields))
    return [check(row) for row in rows[1:]]


def check(row):
    """Returns the entry of a row. Throws ValueError if it is not sound."""
    if len(row) != len(Entry._fields):
        raise ValueError(f"record.csv: {','.join(row)}: not {len(Entry._fields)} fields")
    entry = Entry(*row)
    for field, pattern in (("date", r"\d{4}-\d\d-\d\d"), ("commit", "[0-9a-f]{7,40}"), ("minutes", r"\d+"),
                           ("machine", ".+"), ("result", "passed")):
        if not re.fullmatch(pattern, getattr(entry, field)):
            raise ValueError(f"record.csv: {','.join(row)}: {field} is not sound")
    return entry


def line(entry):
    """Returns the line of an entry. Names of machines have no comma or quote."""
    return ",".join(entry)


def machine():
    """Returns this machine in words: its processor and the cores that a job may use."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = re.findall(r"^model name\s*: (.*)$", file.read(), re.MULTILINE)
    name = re.sub(r'[",]|\s+(?=\s|$)', "", names[0]) if names else os.uname().machine
    return f"{name} with {len(os.sched_getaffinity(0))} cores"
