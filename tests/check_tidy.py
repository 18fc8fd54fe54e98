#!/usr/bin/python3
"""Runs clang-tidy on the sources of lib/ and drivers/ that changed since their last clean run.

    tests/check_tidy.py BUILD_FOLDER [--all] [--commits N | --part K/N] [--minutes N]

A source counts as unchanged if its text, that of each of the project's headers that it includes, its compile command,
.clang-tidy and the version of clang-tidy are those of a clean run. The hashes of clean runs stand in
$XDG_CACHE_HOME/ixos-tidy (default ~/.cache/ixos-tidy), so that a fresh clone profits too. --all checks every source.
--commits takes the sources that changed in the last N commits, and so many others that each changed header is included
by one of them, if the history goes back so far and .clang-tidy is the same. --part takes the K-th of N parts of all
sources, which a hash of their names makes. --minutes begins no source later, and says how many were left out. The build
folder must have been built with Ninja. The exit status is 1 if clang-tidy found anything.
"""
import argparse
import concurrent.futures
import hashlib
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "structure"))
from compile_commands import read_commands  # noqa: E402
from content_hash import PassedChecks, hash_contents  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))


def dependencies(build):
    """By object file, the files that Ninja saw its compiler read."""
    found, target = {}, None
    for line in subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout.splitlines():
        if line.startswith("    "):
            found[target].append(os.path.normpath(os.path.join(build, line.strip())))
        elif line:
            target = line.split(":")[0]
            found[target] = []
    return found


def key(source, command, files, version):
    """Returns the hash of what a clean run depends on: the same in every clone."""
    own = {source, os.path.join(ROOT, ".clang-tidy")} | {f for f in files if f.startswith(ROOT + "/lib/") or
                                                        f.startswith(ROOT + "/drivers/")}
    return hash_contents(ROOT, [os.path.relpath(path, ROOT) for path in own], version, command.replace(ROOT, ""))


def changed_files(commits):
    """Returns the files that differ from those of so many commits ago; None if that is not known."""
    done = subprocess.run(["git", "-C", ROOT, "diff", "--name-only", "HEAD~%d" % commits], capture_output=True, text=True)
    return {os.path.join(ROOT, name) for name in done.stdout.splitlines()} if done.returncode == 0 else None


def covering(sources, changed):
    """Returns the sources that changed, those of which it is not known what they read, and enough others to include each
    changed file that some source includes. `sources`: by name, the files that they read."""
    found = {source: changed.intersection([source, *files]) for source, files in sources.items()}
    chosen = [source for source in sources if source in changed or not sources[source]]
    left = set().union(*found.values()).difference(*(found[source] for source in chosen))
    while left:
        best = max(found, key=lambda source: (len(left & found[source]), -len(sources[source])))
        chosen.append(best)
        left -= found[best]
    return chosen


def part_of(source, parts):
    """Returns the number, from 1 to `parts`, of the part that a source belongs to. Every clone agrees on it."""
    return int(hashlib.sha256(os.path.relpath(source, ROOT).encode()).hexdigest(), 16) % parts + 1


def read_part(text):
    """Returns the two numbers of K/N."""
    match = re.fullmatch(r"(\d+)/(\d+)", text)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError(f"{text} is no part; write 1/4 for the first of four")
    return int(match[1]), int(match[2])


def tidy(source, commands, end):
    """Returns whether a source is clean, and what clang-tidy says. The first is None if the time has come to an end."""
    if time.monotonic() > end:
        return None, ""
    done = subprocess.run(["clang-tidy", "-p", commands, "--quiet", source], capture_output=True, text=True)
    return done.returncode == 0 and "warning:" not in done.stdout, done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build")
    parser.add_argument("--all", action="store_true", help="check unchanged sources too")
    choice = parser.add_mutually_exclusive_group()
    choice.add_argument("--commits", type=int, metavar="N", help="only what changed in the last N commits")
    choice.add_argument("--part", type=read_part, default=(1, 1), metavar="K/N", help="only the K-th of N parts")
    parser.add_argument("--minutes", type=float, default=math.inf, metavar="N", help="begin no source after N minutes")
    options = parser.parse_args()
    end = time.monotonic() + 60 * options.minutes
    changed = changed_files(options.commits) if options.commits else None
    if changed is not None and os.path.join(ROOT, ".clang-tidy") in changed:
        changed = None
    build = os.path.abspath(options.build)
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    folders = (ROOT + "/lib/", ROOT + "/drivers/")
    commands = [command for command in read_commands(build) if str(command.source).startswith(folders)]
    seen = dependencies(build)
    passed = PassedChecks("ixos-tidy")
    states, read = {}, {}
    for command in commands:
        source = str(command.source)
        files = seen.get(command.after("-o"), [])  # the object's path is what the command writes
        states[source] = key(source, shlex.join(command.words), files, version)
        read[source] = files
    chosen = read if changed is None else covering(read, changed)
    part, parts = options.part
    todo = [(source, states[source]) for source in chosen if part_of(source, parts) == part
            if options.all or not read[source] or states[source] not in passed]
    print("clang-tidy on %d of the sources of lib and drivers" % len(todo), flush=True)
    clean, left_out = True, 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool, tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "compile_commands.json"), "w") as file:
            json.dump([command.as_entry() for command in commands], file)
        for (source, state), (good, output) in zip(todo, pool.map(lambda t: tidy(t[0], folder, end), todo)):
            if good is None:
                left_out += 1
            elif good:
                passed.add(state)
            else:
                clean = False
                print(output, flush=True)
    if left_out:
        print("left out for want of time: %d sources" % left_out)
    sys.exit(0 if clean else 1)


if __name__ == "__main__":
    main()
