"""The data file of a table: who measured it, when, where and how, and its rows."""
import datetime
import json
import math
import os
import pathlib
import re
import sys

from . import machine
from .table import ROOT

FOLDER = ROOT / "docs/results/data"
TRIAL = "a short trial"  # a state of a table
USED = re.compile(r"(?<![\w/.-])(?:xml|meshes|tests|docs)/[\w/.-]+\.(?:xml|py|sh)\b")  # files in command lines


def path_of(name):
    """Returns the path of a table's data file."""
    return FOLDER / f"{name}.json"


def read(name):
    """Returns the data of a table, or None if it was never measured."""
    path = path_of(name)
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def plain(value):
    """Returns a number as JSON has it: none of NumPy's, and no number that is not finite."""
    value = value.item() if hasattr(value, "item") else value
    return None if isinstance(value, float) and not math.isfinite(value) else value


def make(table, rows, context, seconds):
    """Returns the data of a measurement that has just ended."""
    return {"table": table.name, "command": command_of(table.name), "programs": context.commands,
            "machine": machine.describe(), "commit": machine.commit(), "changes": machine.has_changes(),
            "date": datetime.date.today().isoformat(), "seconds": round(seconds, 1), "trial": context.trial,
            "columns": [column.key for column in table.columns],
            "rows": [{key: plain(value) for key, value in row.items()} for row in rows]}


def write(data):
    """Writes the data file of a table, all of it or nothing."""
    text = json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False)
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = path_of(data["table"])
    whole = path.with_suffix(".new")
    whole.write_text(text + "\n", encoding="utf-8")
    os.replace(whole, path)


def command_of(name):
    """Returns the command that measures a table."""
    return f"docs/measure {name}"


def duration(seconds):
    """Returns a time in words."""
    minutes = round(seconds / 60)
    return f"{round(seconds)} s" if seconds < 90 else f"{minutes} minutes"


def caption(data):
    """Returns the line below a table: when, of which code, where and in which time it was measured."""
    where = data["machine"]
    cores = f"{where['cores']} core{'s' if where['cores'] != 1 else ''}"
    place = f"{where['processor']} ({', '.join(filter(None, [cores, where['instruction_set']]))})"
    first = "Not measured yet: a short trial of" if data["trial"] else "Measured"
    changes = " with changes" if data["changes"] else ""
    return f"*{first} {data['date']} at commit {data['commit']}{changes} on {place}, in {duration(data['seconds'])}.*"


def code(table, data):
    """Returns the files and folders on which the numbers of a table depend: those that it states, the module of its
    function, and the scenes and scripts in the command lines that were run."""
    module = pathlib.Path(sys.modules[table.measure.__module__].__file__).relative_to(ROOT)
    used = {file for line in data["programs"] for file in USED.findall(line)}
    return sorted({*table.code, str(module), *used})


def state(table, data):
    """Returns in words why a table should be measured anew, or "" if it need not be."""
    if data is None:
        return "never measured"
    if data["trial"]:
        return TRIAL
    if data["columns"] != [column.key for column in table.columns]:
        return "other columns"
    changed = machine.changed_since(data["commit"], code(table, data))
    if changed is None:
        return "unknown commit"
    return f"code changed since: {changed} file{'s' if changed > 1 else ''}" if changed else ""
