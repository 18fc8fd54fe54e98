#!/usr/bin/python3
"""Compiles each header of lib alone: a header must include what it needs, and may be included twice. A stable header,
lib/ixos, must declare each name that its comment lists.

    tests/structure/headers_test.py BUILD_FOLDER [--all] [--installed] [HEADER...]

The compiler only checks the syntax, with the flags that the build folder has for the sources of lib. Headers are named
by their path below lib; default: all. A header is not checked again while its text, that of each header of lib that it
includes, the flags and the version of the compiler are those of a check that it passed, nor if a source of lib includes
it first: every build compiles it then. --all checks it all the same.
With --installed, BUILD_FOLDER is that of a program that uses an installed Ixos: only the stable headers, lib/ixos,
compile, with its flags. These checks are noted in $XDG_CACHE_HOME/ixos-headers (default ~/.cache/ixos-headers). The
exit status is 1 if a header does not compile.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
from compile_commands import read_commands  # noqa: E402
from content_hash import PassedChecks, hash_contents  # noqa: E402
from includes import (LIB, ROOT, collect_headers, is_header_of_lib, list_files, read_includes,  # noqa: E402
                      read_stable_names)

INSTALLATION = ROOT / "cmake" / "IxosHeaders.cmake"  # the headers are installed by it
MOST_LINES = 3  # of one header's errors: the rest follows from the first
ENVIRONMENT = {**os.environ, "LC_ALL": "C"}  # errors in English, so that they can be found


def read_command(build, installed):
    """Returns the compiler with the flags of the sources of lib, or of all sources of a program that uses an installed
    Ixos, and the folder where the build runs it."""
    commands = [command for command in read_commands(build) if installed or LIB in command.source.parents]
    if not commands:
        sys.exit(f"{build}/compile_commands.json names no source of lib: configure the build with CMake again")
    # Those of ixos_solvers see fewer folders.
    commands = [command for command in commands if "/ixos_others.dir/" in command.after("-o")] or commands
    # The shortest command belongs to a source without additional flags.
    command = min(commands, key=lambda command: len(command.words))
    words = list(command.words)
    for option in ("-o", "-c"):
        at = words.index(option)
        del words[at:at + 2]
    return words, command.folder


def list_first_headers():
    """Returns the headers that a source of lib includes before anything else."""
    firsts = (read_includes(source)[:1] for source in list_files(".cpp"))
    return {included for first in firsts for _, included, in_quotes in first if in_quotes}


def use(header):
    """Returns a source that includes the header twice and uses the names that a stable header lists."""
    names = read_stable_names(header) if header.startswith("ixos/") else []
    uses = "".join(f"using ixos::{name};\n" for name in names)
    return f'#include "{header}"\n' * 2 + f"namespace program {{\n{uses}}}\n"


def compile_header(header, command, folder):
    """Returns the first errors of the compiler; an empty list if there are none."""
    # The text comes by standard input: in a main file, compilers object to "#pragma once".
    done = subprocess.run([*command, "-fsyntax-only", "-x", "c++", "-"], input=use(header), cwd=folder, env=ENVIRONMENT,
                          capture_output=True, text=True)
    if done.returncode == 0:
        return []
    lines = done.stderr.splitlines()
    return ([line for line in lines if "error:" in line] or lines or [f"exit status {done.returncode}"])[:MOST_LINES]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("headers", nargs="*")
    parser.add_argument("--all", action="store_true", help="check unchanged headers too")
    parser.add_argument("--installed", action="store_true", help="check the stable headers as they are installed")
    options = parser.parse_args()
    if unknown := [header for header in options.headers if not is_header_of_lib(header)]:
        sys.exit(f"no header of lib: {', '.join(unknown)}")
    command, folder = read_command(options.build.resolve(), options.installed)
    version = subprocess.run([command[0], "--version"], capture_output=True, text=True, check=True).stdout
    flags = [word.replace(str(ROOT), "") for word in command]  # the same in every clone
    headers = options.headers or list_files(".hpp")
    if options.installed:
        headers = [header for header in headers if header.startswith("ixos/")]
        flags.append(INSTALLATION.read_text(encoding="utf-8"))
    keys = {header: hash_contents(LIB, collect_headers(header), use(header), version, *flags)
            for header in headers}
    passed = PassedChecks("ixos-headers")
    compiled = set() if options.installed or options.headers else list_first_headers()
    todo = [header for header in headers if options.all or (header not in compiled and keys[header] not in passed)]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for header, errors in zip(todo, pool.map(lambda h: compile_header(h, command, folder), todo)):
            if errors:
                failed += 1
                print(f"lib/{header} does not compile alone: include what it needs, and list declared names only",
                      *errors, sep="\n  ", flush=True)
            else:
                passed.add(keys[header])
    print(f"{len(todo)} headers of lib compiled alone, {failed} failed; {len(headers) - len(todo)} had not changed or "
          "stand first in a source")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
