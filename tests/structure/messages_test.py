#!/usr/bin/python3
"""Verifies that the messages which docs/help/failed-runs.md explains are those of the library.

The first cell of a row of its tables is a part of a message between backticks. It must occur in a string of lib.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def strings(source):
    """Returns the strings of C++ source; those that stand one after the other are one."""
    joined = re.sub(r'"\s*\n\s*"', "", source)
    return STRING.findall(joined)


def main():
    page = ROOT / "docs/help/failed-runs.md"
    messages = re.findall(r"^\| `([^`]+)` \|", page.read_text(encoding="utf-8"), re.MULTILINE)
    known = "\n".join(text for path in (ROOT / "lib").rglob("*.cpp") for text in strings(path.read_text(encoding="utf-8")))
    unknown = [message for message in messages if message not in known]
    for message in unknown:
        print(f"{page.relative_to(ROOT)}: no message of lib has \"{message}\"")
    if len(messages) < 10:
        print(f"{page.relative_to(ROOT)}: only {len(messages)} messages found")
    return 1 if unknown or len(messages) < 10 else 0


if __name__ == "__main__":
    sys.exit(main())
