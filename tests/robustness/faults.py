#!/usr/bin/python3
"""Lets one call fail in each of many runs, and looks at how each run ends and whether it can be continued.

    tests/robustness/faults.py [--most 20] [--every ball] [--kinds write,sync] [--only ball] [--seconds 60]
        [--driver build/release/drivers/ixos]

A preloaded library (fault_injector.cpp) makes the n-th call of a kind fail, on one rank. A run has four good ends: nothing
changed (exit status 0, results bit for bit); or one of the exit statuses 2, 3 and 4 with words on standard error. Then
the run is continued from every checkpoint that it left, undisturbed: the results must be those of a run without any
fault, bit for bit. All else is bad: silent (status 0 and other results), a signal, a run that does
not end, the status of a defect (1), a restart that fails or differs. Prints a table in Markdown; the exit status is 1
where anything is bad.
"""
import argparse
import collections
import concurrent.futures
import csv
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import ENVIRONMENT, ROOT, STEPS, driver_command  # noqa: E402

FILES = ["open", "close", "read", "short_read", "write", "short_write", "full", "sync", "rename", "truncate", "remove"]
KINDS = FILES + ["allocate", "mpi"]
GOOD = ["no effect", "exit status 2", "exit status 3", "exit status 4"]


def scenarios():
    """Name, scene, settings, ranks, faulty rank, whether the faulty run is a restart."""
    ball = [STEPS + "Final Time=0.02", "Output/Fields Interval=5", "Output/Checkpoint/Interval=5"]
    hdf5 = ["Output/Fields Format=HDF5"]
    strip = [STEPS + "Time Step=1", STEPS + "Final Time=4", "Output/Fields Interval=1", "Output/Checkpoint/Interval=1",
             "Histories/Pull/Rate Ramp/Length=2", "Linear Solver/Linear Solver Type=Belos", "Linear Solver/Preconditioner Type=MueLu"]
    front = [STEPS + "Final Time=24", STEPS + "Time Step=1", "Histories/Pull/Rate Ramp/Length=20",
             "Mesh/Box/Divisions={40, 1}", "Mesh/Adapt/Interval=3", "Mesh/Adapt/Budget=1",
             "Output/Fields Time Interval=0", "Output/Fields Interval=4", "Output/Checkpoint/Interval=4"]
    yield "ball", "ball", ball, 1, 0, False
    yield "strip-front", "strip-front", front, 1, 0, False
    yield "strip-front, restarted", "strip-front", front, 1, 0, True
    yield "strip-front, rank 1 of 2", "strip-front", front, 2, 1, False
    yield "ball, HDF5 frames", "ball", ball + hdf5, 1, 0, False
    yield "ball, restarted", "ball", ball, 1, 0, True
    yield "ball, restarted, HDF5 frames", "ball", ball + hdf5, 1, 0, True
    yield "strip, MueLu, HDF5 frames", "strip", strip + hdf5, 1, 0, False
    for rank in (0, 1):
        yield "ball, rank %d of 2" % rank, "ball", ball, 2, rank, False
        yield "ball, HDF5 frames, rank %d of 2" % rank, "ball", ball + hdf5, 2, rank, False
    yield "ball, restarted, rank 1 of 2", "ball", ball, 2, 1, True
    yield "ball, restarted, HDF5 frames, rank 1 of 2", "ball", ball + hdf5, 2, 1, True


def history(folder):
    with open(os.path.join(folder, "history.csv")) as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        row.pop("wall_seconds", None)
    return rows


def results(folder):
    """All that a run must leave as an undisturbed one does."""
    try:
        fields = {name: open(os.path.join(folder, name), "rb").read() for name in sorted(os.listdir(folder))
                  if name.startswith("fields.e")}
        return history(folder), fields
    except (OSError, csv.Error, UnicodeDecodeError):
        return None


class Scenario:
    def __init__(self, options, name, scene, settings, ranks, rank, restarted, folder):
        self.options, self.name, self.rank, self.folder = options, name, rank, folder
        self.scene, self.settings, self.ranks = os.path.join(ROOT, "xml", scene + ".xml"), settings, ranks
        self.begun = os.path.join(folder, "begun") if restarted else None
        if restarted:  # half way
            half = settings + [STEPS + "Final Time=%g" % (float(settings[0].split("=")[1]) / 2)]
            self.require(self.run(self.begun, settings=half))
        self.require(self.run(os.path.join(folder, "undisturbed")))
        self.expected = results(os.path.join(folder, "undisturbed"))

    @staticmethod
    def require(end):
        if end[0] != 0:
            sys.exit("an undisturbed run failed: %s" % (end,))

    def run(self, folder, fault=None, restart=False, settings=None, count=None):
        """Exit status and standard error; the status is None where the run does not end."""
        arguments = ["--output", folder] + (["--restart", folder if restart is True else restart] if restart else [])
        command = driver_command(self.options.driver, self.scene, arguments, settings or self.settings, self.ranks)
        environment = dict(ENVIRONMENT)
        if fault:
            injected = {"LD_PRELOAD": self.options.injector, "IXOS_FAULT": fault, "IXOS_FAULT_RANK": str(self.rank)}
            if count:
                injected["IXOS_FAULT_COUNT"] = count
            if self.ranks == 1:
                environment.update(injected)
            else:  # the ranks, not their launcher
                at = command.index(self.options.driver)
                command[at:at] = ["env"] + ["%s=%s" % item for item in injected.items()]
        try:
            done = subprocess.run(command, env=environment, timeout=self.options.seconds, capture_output=True, text=True,
                                  errors="replace")
            return done.returncode, done.stderr.strip()
        except subprocess.TimeoutExpired:
            return None, "not done after %g s" % self.options.seconds

    def prepare(self, folder):
        shutil.rmtree(folder, ignore_errors=True)
        if self.begun:
            shutil.copytree(self.begun, folder, symlinks=True)

    def calls(self, kind):
        folder, count = os.path.join(self.folder, "counted"), os.path.join(self.folder, "count")
        self.prepare(folder)
        self.require(self.run(folder, kind + ":0", restart=bool(self.begun), count=count))
        with open(count) as file:
            return int(file.read())

    def judge(self, kind, n):
        """How the run ended, how its continuation ended, and what it said."""
        folder = os.path.join(self.folder, "%s-%d" % (kind, n))
        self.prepare(folder)
        status, words = self.run(folder, "%s:%d" % (kind, n), restart=bool(self.begun))
        end = "no effect"
        if status is None:
            end = "hung"
        elif status == 0 and results(folder) != self.expected:
            end = "silent"
        elif status < 0 or status > 128 or "signal" in words:
            end = "signal"
        elif status != 0:
            end = "exit status %d" % status
            if "ixos: " not in words:
                end += " without words"
        continued = self.continued(folder)
        shutil.rmtree(folder, ignore_errors=True)
        return end, continued, words

    def continued(self, folder):
        """Restarts from each checkpoint in a copy of the folder; what went wrong, or what came of it."""
        there = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        ends = []
        for name in there:
            if not (name.startswith("checkpoint-") and name.endswith(".h5")):
                continue
            copy = folder + "-copy"
            shutil.rmtree(copy, ignore_errors=True)
            shutil.copytree(folder, copy, symlinks=True)
            status, words = self.run(copy, restart=os.path.join(copy, name))
            if status == 2 and "Choose another --output" in words:  # rows or frames are gone, the checkpoint is sound
                ends.append("results refused")
            elif status != 0:
                ends.append("restart from %s failed: %s %s" % (name, status, words))
            else:
                ends.append("same" if results(copy) == self.expected else "restart from %s differs" % name)
            shutil.rmtree(copy, ignore_errors=True)
        wrong = [end for end in ends if end not in ("same", "results refused")]
        return wrong[0] if wrong else max(ends) if ends else "no checkpoint"


def chosen(total, most):
    if most == 0 or total <= most:
        return list(range(1, total + 1))
    if most == 1:
        return [1 + total // 2]
    return sorted({1 + round(i * (total - 1) / (most - 1)) for i in range(most)})


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    build = os.path.join(ROOT, "build/release")
    parser.add_argument("--driver", default=os.path.join(build, "drivers/ixos"))
    parser.add_argument("--injector", default=os.path.join(build, "tests/libfault_injector.so"))
    parser.add_argument("--most", type=int, default=20, help="calls of each kind, spread evenly; 0: all (default: 20)")
    parser.add_argument("--every", default="ball", help="the scenario in which every call fails once (default: ball)")
    parser.add_argument("--most-allocations", type=int, default=200, help="allocations and MPI calls (default: 200)")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--only", default="", help="scenarios whose name begins with this")
    parser.add_argument("--seconds", type=float, default=60, help="a run that takes longer hangs")
    parser.add_argument("--verbose", action="store_true", help="print every end")
    options = parser.parse_args()
    scenes = [s for s in scenarios() if s[0].startswith(options.only)]
    if not scenes:
        sys.exit("no scenario begins with \"%s\"" % options.only)
    bad = []
    print("| scenario | kind | calls | faults | %s | bad end | same | no checkpoint | results refused | bad restart |" %
          " | ".join(GOOD))
    print("|" + "---|" * (len(GOOD) + 9))
    for name, scene, settings, ranks, rank, restarted in scenes:
        with tempfile.TemporaryDirectory(prefix="ixos-faults-") as folder:
            scenario = Scenario(options, name, scene, settings, ranks, rank, restarted, folder)
            for kind in options.kinds.split(","):
                total = scenario.calls(kind)
                most = 0 if name == options.every else options.most
                faults = chosen(total, options.most_allocations if kind in ("allocate", "mpi") else most)
                with concurrent.futures.ThreadPoolExecutor(max(1, (os.cpu_count() or 2) // ranks)) as pool:
                    judged = list(pool.map(lambda n: scenario.judge(kind, n), faults))
                ends = collections.Counter(end for end, _, _ in judged)
                then = collections.Counter(continued for _, continued, _ in judged)
                fine = ["same", "no checkpoint", "results refused"]
                wrong = [(n, *j) for n, j in zip(faults, judged) if j[0] not in GOOD or j[1] not in fine]
                bad += wrong
                print("| %s | %s | %d | %d | %s | %d | %s | %d |" % (
                    name, kind, total, len(faults), " | ".join(str(ends[g]) for g in GOOD),
                    sum(c for e, c in ends.items() if e not in GOOD), " | ".join(str(then[f]) for f in fine),
                    sum(c for t, c in then.items() if t not in fine)), flush=True)
                for case in judged if options.verbose else []:
                    print("   ", case, file=sys.stderr)
                for case in wrong:
                    print("   ", name, kind, *case, file=sys.stderr, flush=True)
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
