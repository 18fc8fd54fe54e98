#!/usr/bin/python3
"""Flips bits in the memory of running jobs, and asks whether the watch on the energy balance notices.

    tests/robustness/flips.py [--trials 60] [--flips 10] [--seed 1] [--driver build/release/drivers/ixos]

Each trial stops a run of the ball at a random moment, flips one bit in each of ten doubles of its writable memory (of the
exponent or of the upper mantissa, in words that hold a number of ordinary size), and lets it go on. A trial counts as
changed where energies or the least gap, to the end of the run, differ from those of an undisturbed run by more than 1e-3
of their largest value; every changed run must have warned, failed, or ended otherwise than well. The run ends before the
motion is chaotic. Prints a table in Markdown; the exit status is 1 where a changed run said nothing.
"""
import argparse
import csv
import os
import random
import signal
import struct
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import ENVIRONMENT, ROOT, STEPS, driver_command  # noqa: E402

SETTINGS = [STEPS + "Final Time=0.45", "Mesh/Disk/Core Divisions=16", "Mesh/Disk/Rings=6", "Output/Checkpoint/Keep=0",
            "Output/Fields Interval=0"]
COLUMNS = ["kinetic_energy", "elastic_energy", "contact_energy", "min_gap"]


def start(options, scheme, folder):
    command = driver_command(options.driver, os.path.join(ROOT, "xml/ball.xml"), ["--output", folder],
                             SETTINGS + ["Time Integrator/Type=" + scheme], 1)
    command.remove("--quiet")  # it would hide the warning
    return subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def history(folder):
    try:
        with open(os.path.join(folder, "history.csv")) as file:
            return [[float(row[c]) for c in COLUMNS] for row in csv.DictReader(file)]
    except (OSError, ValueError, TypeError):
        return []


def change(rows, reference):
    """The largest difference of a column over its largest value; infinite where rows are missing."""
    if len(rows) != len(reference):
        return float("inf")
    largest = [max(abs(row[c]) for row in reference) for c in range(len(COLUMNS))]
    return max(abs(a[c] - b[c]) / largest[c] for a, b in zip(rows, reference) for c in range(len(COLUMNS)))


def regions(pid):
    """Writable memory of no file."""
    with open("/proc/%d/maps" % pid) as maps:
        for line in maps:
            words = line.split()
            if words[1].startswith("rw-p") and (len(words) < 6 or words[5] == "[heap]"):
                yield tuple(int(end, 16) for end in words[0].split("-"))


def flip(pid, flips, chance):
    """Flips bits in so many doubles of ordinary size. Returns how many it found."""
    found = []
    with open("/proc/%d/mem" % pid, "r+b", buffering=0) as memory:
        for begin, end in regions(pid):
            if end - begin > 1 << 26:
                continue
            try:
                memory.seek(begin)
                data = memory.read(end - begin)
            except OSError:
                continue
            for offset in range(0, len(data) - 7, 8):
                size = abs(struct.unpack_from("<d", data, offset)[0])
                if 1e-6 < size < 1e3 and data[offset:offset + 3] != b"\0\0\0":  # not a round number
                    found.append((begin + offset, data[offset:offset + 8]))
        for address, word in chance.sample(found, min(flips, len(found))):
            bit = chance.choice(list(range(46, 63)))
            flipped = struct.unpack("<Q", word)[0] ^ (1 << bit)
            memory.seek(address)
            memory.write(struct.pack("<Q", flipped))
    return len(found)


def trial(options, scheme, folder, chance, seconds, reference):
    process = start(options, scheme, folder)
    time.sleep(chance.uniform(0.3, 0.9) * seconds)
    os.kill(process.pid, signal.SIGSTOP)
    if process.poll() is not None:
        return "too late", 0, ""
    words = flip(process.pid, options.flips, chance)
    os.kill(process.pid, signal.SIGCONT)
    try:
        errors = process.communicate(timeout=60)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        return "hung", words, process.communicate()[1]
    if process.returncode != 0:
        return "ended with %d" % process.returncode, words, errors
    moved = change(history(folder), reference)
    if moved > 1e-3:
        return ("noticed" if "energy balance moved" in errors else "SILENT"), words, "changed by %.2g" % moved
    return ("alarm without change" if "energy balance moved" in errors else "no change"), words, "%.2g" % moved


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--driver", default=os.path.join(ROOT, "build/release/drivers/ixos"))
    parser.add_argument("--trials", type=int, default=60, help="for each scheme")
    parser.add_argument("--flips", type=int, default=10, help="in each trial")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--schemes", default="Energy-Momentum,Average Vector Field")
    options = parser.parse_args()
    chance = random.Random(options.seed)
    silent = 0
    print("| scheme | trials | end | runs |\n|---|---|---|---|")
    for scheme in options.schemes.split(","):
        ends = {}
        with tempfile.TemporaryDirectory(prefix="ixos-flips-") as folder:
            begun = time.time()
            errors = start(options, scheme, folder + "/undisturbed").communicate()[1]
            seconds = time.time() - begun
            reference = history(folder + "/undisturbed")
            if not reference or "energy balance" in errors:
                sys.exit("the undisturbed run: " + errors)
            for number in range(options.trials):
                end, words, said = trial(options, scheme, "%s/%d" % (folder, number), chance, seconds, reference)
                ends[end] = ends.get(end, 0) + 1
                if end == "SILENT":
                    silent += 1
                    print("    trial %d of %s: %s, %d words" % (number, scheme, said, words), file=sys.stderr)
        for end, count in sorted(ends.items()):
            print("| %s | %d | %s | %d |" % (scheme, options.trials, end, count), flush=True)
    sys.exit(1 if silent else 0)


if __name__ == "__main__":
    main()
