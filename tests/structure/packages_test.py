#!/usr/bin/python3
"""Compares the Debian packages with what the build installs.

    tests/structure/packages_test.py INSTALLED

Each file below the folder INSTALLED (of cmake --install) must be matched by one line of one of debian/*.install, each
line must match a file, and the packages must need what drivers/common.sh installs for a build. The exit status is 1 if
not.
"""
import fnmatch
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEBIAN = ROOT / "debian"
BY_RULES = [("ixos", "usr/lib/*/glibc-hwcaps")]  # debian/rules, on the architectures that have it
OPTIONAL = {"usr/share/doc/ixos/html", "usr/share/man", "usr/lib/*/glibc-hwcaps",
            "usr/lib/python3/dist-packages/ixos"}  # what a build may leave out
ONLY_TESTS = {"ccache", "libgtest-dev", "libbenchmark-dev", "python3-mpi4py"}
ESSENTIAL = {"g++"}  # of every build


def in_package(path):
    """Returns where a package has an installed file. Debian puts libraries in a folder of the architecture."""
    parts = path.parts
    if parts[0] == "lib" and parts[1] != "python3":
        parts = ("lib", "x86_64-linux-gnu", *parts[1:])
    return "/".join(("usr", *parts))


def matches(path, pattern):
    """Returns whether the pattern names the path or a folder of it. A star stands for one component or a part of it."""
    parts, wanted = path.split("/"), pattern.split("/")
    return len(parts) >= len(wanted) and all(map(fnmatch.fnmatchcase, parts, wanted))


def install_lines():
    """Returns (package, pattern) for all packages."""
    lines = [(file.stem, line) for file in sorted(DEBIAN.glob("*.install")) for line in file.read_text().split()]
    return lines + BY_RULES


def file_problems(installed):
    paths = [in_package(path.relative_to(installed)) for path in sorted(installed.rglob("*")) if not path.is_dir()]
    lines, used = install_lines(), set()
    for path in paths:
        found = [line for line in lines if matches(path, line[1])]
        used.update(found)
        if len(found) != 1:
            yield f"{path} is in {len(found)} lines of debian/*.install"
    for package, pattern in lines:
        if (package, pattern) not in used and pattern not in OPTIONAL:
            yield f"debian/{package}.install: nothing is installed as {pattern}"


def dependency_problems():
    needed = re.search(r'^packages="([^"]*)"', (ROOT / "drivers/common.sh").read_text(), re.MULTILINE)[1].split()
    control = (DEBIAN / "control").read_text()
    stated = re.search(r"^Build-Depends:(.*?)^\S", control, re.MULTILINE | re.DOTALL)[1]
    stated = {entry.split()[0] for entry in stated.split(",")}
    for package in sorted(set(needed) - stated - ONLY_TESTS - ESSENTIAL):
        yield f"debian/control: Build-Depends lacks {package}, which drivers/common.sh installs"


def main():
    installed = pathlib.Path(sys.argv[1])
    problems = [*file_problems(installed), *dependency_problems()]
    if problems:
        sys.exit("\n".join(f"packages_test.py: {problem}" for problem in problems))


main()
