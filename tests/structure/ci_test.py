#!/usr/bin/python3
"""Checks that the slices of continuous integration, .ci/table.py, leave nothing out.

    tests/structure/ci_test.py BUILD_FOLDER

Each long test is in one slice, each folder of the library and each unit test in one that runs it under sanitizers, each
source in one that runs clang-tidy. tests/bench/short.py has each file of tests/bench, and tests/readme/blocks.py has no
command that the README does not have. The record is sound, and names slices that exist and do not take too long. Every
slice has a program and its turn. tests/packages/install.sh runs all tests of debian/tests/control. The exit status is 1
if not.
"""
import collections
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in (".ci", "tests", "tests/bench", "tests/readme")]
import blocks  # noqa: E402
import check_tidy  # noqa: E402
import record  # noqa: E402
import short  # noqa: E402
from table import LIMIT, SLICES, slice_of  # noqa: E402

BUILD = sys.argv[1]


def list_tests(*arguments):
    """Returns the labels of the tests that ctest runs with these arguments, by name."""
    done = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1", *arguments], capture_output=True,
                          text=True, check=True)
    found = {}
    for test in json.loads(done.stdout)["tests"]:
        properties = {each["name"]: each["value"] for each in test["properties"]}
        found[test["name"]] = properties.get("LABELS", [])
    return found


def arguments_of(command, program):
    """Returns the words behind a program in a command."""
    words = shlex.split(command)
    return words[words.index(program) + 1:]


def check_once(what, names, parts):
    """Yields a message for each name that is not in exactly one of the parts."""
    counts = collections.Counter(name for part in parts for name in part)
    for name in names:
        if counts[name] != 1:
            yield f"{what} {name} is in {counts[name]} slices"


def check_tests():
    every = list_tests()
    names = [name for name in every if "long" in every[name]]
    commands = [each.command for each in SLICES if each.name.startswith("long-")]
    if not names or not commands:
        yield "no long test, or no slice long-*: is this check out of date?"
    yield from check_once("long test", names,
                          [list_tests(*arguments_of(command, "tests/run.sh")) for command in commands])


def check_sanitizers():
    lists = (ROOT / "lib/CMakeLists.txt").read_text(encoding="utf-8")
    folders = {name: words.split()
               for name, words in re.findall(r"^ *ixos_sanitized\((\w+) ([^)]*)\)$", lists, re.MULTILINE)}
    library = sorted(folder.name for folder in (ROOT / "lib").iterdir() if any(folder.rglob("*.cpp")))
    yield from check_once("folder of lib under sanitizers", library, folders.values())
    commands = [each.command for each in SLICES if each.name.startswith("sanitizers-")]
    parts = [arguments_of(command, "tests/sanitizers/run.sh")[0] for command in commands]
    yield from check_once("part under sanitizers", ["headers", *folders], [[part] for part in parts])
    script = (ROOT / "tests/sanitizers/run.sh").read_text(encoding="utf-8")
    chosen = "|".join(re.findall(r"^ .*tests='([^']+)'", script, re.MULTILINE))
    for name, labels in list_tests().items():
        if "unit" in labels and "long" not in labels and not re.match(rf"(unit|guide)\.({chosen})(\.|$)", name):
            yield f"unit test {name} is in no part of tests/sanitizers/run.sh"


def check_sources():
    sources = [str(file) for folder in ("lib", "drivers") for file in (ROOT / folder).rglob("*.cpp")]
    parts = []
    for command in (each.command for each in SLICES if each.name.startswith("tidy-")):
        part, of = check_tidy.read_part(arguments_of(command, "tests/check_tidy.py")[-1])
        parts.append([source for source in sources if check_tidy.part_of(source, of) == part])
    yield from check_once("source", sources, parts)


def check_benchmarks():
    files = {file.name for file in (ROOT / "tests/bench").iterdir() if file.is_file() and file.name != "short.py"}
    known = short.RUNS.keys() | short.WITHOUT_RUN.keys()
    for name in sorted(files - known):
        yield f"tests/bench/{name}: name it in tests/bench/short.py"
    for name in sorted(known - files):
        yield f"tests/bench/{name} does not exist: delete its entry in tests/bench/short.py"


def check_record():
    try:
        entries = record.read(record.FILE.read_text(encoding="utf-8").splitlines())
    except ValueError as error:
        yield str(error)
        return
    names = {each.name for each in SLICES}
    for entry in entries:
        if entry.slice not in names:
            yield f".ci/record.csv: {entry.slice} is no slice: delete its lines"
        if int(entry.minutes) > LIMIT:
            yield f".ci/record.csv: {entry.slice} took {entry.minutes} minutes, more than {LIMIT}: split it"


def check_programs():
    for each in SLICES:
        for program in re.findall(r"(?<!\S)(?:tests|docs)/\S+", each.command):
            if not (ROOT / program).is_file() or not os.access(ROOT / program, os.X_OK):
                yield f".ci/table.py: {each.name}: {program} is no program"


def check_packages():
    """The tests of the packages that install.sh runs by name are all that debian/tests/control lists."""
    control = (ROOT / "debian/tests/control").read_text(encoding="utf-8")
    listed = {name for names in re.findall(r"^Tests: (.*)$", control, re.MULTILINE) for name in names.split()}
    script = (ROOT / "tests/packages/install.sh").read_text(encoding="utf-8")
    run = set(re.findall(r"^test_installed (\S+)$", script, re.MULTILINE))
    for name in sorted(listed ^ run):
        yield f"the package test {name} stands in " + ("debian/tests/control" if name in listed else
                                                       "tests/packages/install.sh") + " only"


def check_turns():
    if len({each.name for each in SLICES}) != len(SLICES):
        yield ".ci/table.py: two slices have one name"
    for each in set(SLICES) - {slice_of(commits) for commits in range(len(SLICES))}:
        yield f".ci/table.py: {each.name} never has its turn"


def main():
    problems = [*check_tests(), *check_sanitizers(), *check_sources(), *check_benchmarks(), *blocks.check(),
                *check_record(), *check_programs(), *check_packages(), *check_turns()]
    if problems:
        sys.exit("\n".join(f"ci_test.py: {problem}" for problem in problems))
    print(f"{len(SLICES)} slices leave nothing out")


if __name__ == "__main__":
    main()
