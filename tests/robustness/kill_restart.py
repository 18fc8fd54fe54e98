#!/usr/bin/python3
"""Kills runs with SIGKILL at random moments, restarts them, and compares with runs that nobody disturbed.

    tests/robustness/kill_restart.py [--kills 210] [--seed 1] [--driver build/release/drivers/ixos] [--only ball]

Each scene runs once undisturbed. Then it runs again and is killed at a random moment, on several ranks one of them or all
with the launcher; it is restarted from checkpoint.h5 (or from the beginning, where there is none yet), killed again, and so
on until it ends by itself. Then history.csv but for wall-clock seconds, and every byte of the Exodus files, must be those of
the undisturbed run. Prints a table in Markdown; the exit status is 1 where anything differs.
"""
import argparse
import csv
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import ENVIRONMENT, ROOT, STEPS, driver_command  # noqa: E402

DIRECT = ["Linear Solver/Linear Solver Type=Direct", "Linear Solver/Linear Solver Types/Direct/Solver Type="]
ITERATIVE = ["Linear Solver/Linear Solver Type=Belos", "Linear Solver/Preconditioner Type="]


def scenarios():
    """Name, scene, settings, ranks. Every solver and kind of memory a restart must bring back."""
    def preconditioned(kind):
        return [ITERATIVE[0], ITERATIVE[1] + kind]

    def direct(kind):
        return [DIRECT[0], DIRECT[1] + kind]

    ball = [STEPS + "Final Time=2", "Output/Fields Interval=50"]
    strip = [STEPS + "Time Step=1", STEPS + "Final Time=60", "Output/Fields Time Interval=5"]
    energy_momentum = ["Time Integrator/Type=Energy-Momentum"]
    every, often, seldom = (["Output/Checkpoint/Interval=%d" % n] for n in (1, 7, 40))
    gap_ratio = [STEPS + "Type=Adaptive", STEPS + "Adaptive/Maximum Gap Ratio=1.5", STEPS + "Adaptive/Choose Time Points=true",
                 "Time Integrator/Type=Average Vector Field", STEPS + "Final Time=10", "Output/Fields Interval=50"]
    for ranks in (1, 2):
        yield "ball, Band", "ball", ball + every, ranks
        yield "ball, CHOLMOD", "ball", ball + every + direct("CHOLMOD"), ranks
        yield "ball, Energy-Momentum, Band LU", "ball", ball + often + direct("Band LU") + energy_momentum, ranks
        yield "ball, Energy-Momentum, KLU", "ball", ball + often + direct("KLU") + energy_momentum, ranks
        yield "ball, Bathe, CG with lagged MueLu", "ball", ball + seldom + preconditioned("MueLu") + \
            ["Time Integrator/Type=Bathe Composite"], ranks
        yield "ball, adaptive by the gap ratio", "ball", gap_ratio + often, ranks
        yield "ball, Central Difference", "ball", ball + seldom + ["Time Integrator/Type=Central Difference"], ranks
        yield "ball, HDF5", "ball", [STEPS + "Final Time=0.5", "Output/Fields Interval=10", "Output/Fields Format=HDF5"] + often, ranks
        yield "strip, CG with a lagged factorisation", "strip", strip + every + preconditioned("Direct"), ranks
        yield "strip, CG with lagged MueLu", "strip", strip + every + preconditioned("MueLu"), ranks
        yield "strip, CG with lagged Ifpack2", "strip", strip + [STEPS + "Final Time=20"] + every + \
            preconditioned("Ifpack2") + ["Mesh/Box/Divisions={80, 2}", "Mesh/Sets/contact/Upper={100, 1}",
                                         "Histories/Pull/Rate Ramp/Length=10"], ranks


def history(folder):
    with open(os.path.join(folder, "history.csv")) as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        del row["wall_seconds"]
    return rows


def fields(folder):
    return {name: open(os.path.join(folder, name), "rb").read() for name in sorted(os.listdir(folder))
            if name.startswith("fields.e")}


def descendants(pid):
    """The process and those below it."""
    parents = {}
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/stat" % entry) as file:
                parents.setdefault(int(file.read().rsplit(")", 1)[1].split()[1]), []).append(int(entry))
        except OSError:
            pass
    found = [pid]
    for process in found:
        found += parents.get(process, [])
    return found


class Scene:
    def __init__(self, options, scene, settings, ranks, folder):
        self.folder = folder
        self.command = driver_command(options.driver, os.path.join(ROOT, "xml", scene + ".xml"), ["--output", folder],
                                      settings, ranks)

    def start(self):
        link = os.path.join(self.folder, "checkpoint.h5")
        restart = ["--restart", link] if os.path.exists(link) else []
        return subprocess.Popen(self.command + restart, env=ENVIRONMENT, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True), bool(restart)


def half_written(folder):
    """Was a checkpoint being written? Removes what is left of it, so that it counts once."""
    found = False
    for name in os.listdir(folder) if os.path.isdir(folder) else []:
        if name.endswith(".h5.tmp"):
            os.remove(os.path.join(folder, name))
            found = True
    return found


def send_kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def alive(pid):
    try:
        with open("/proc/%d/stat" % pid) as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def kill(process, chance):
    """All of it, or one rank; then the launcher has to end the others. Returns what hung, if anything."""
    family = descendants(process.pid)
    ranks = family[1:]
    for victim in [chance.choice(ranks)] if ranks and chance.random() < 0.5 else family:
        send_kill(victim)
    end = time.time() + 60
    while any(map(alive, ranks)):
        if time.time() > end:
            for pid in family:
                send_kill(pid)
            return "ranks"
        time.sleep(0.01)
    try:
        process.communicate(timeout=20)
        return ""
    except subprocess.TimeoutExpired:  # Open MPI 4.1 can hang in its own PMIx_server_finalize
        send_kill(process.pid)
        process.communicate()
        return "launcher"


def disturb(options, chance, scene, settings, ranks, folder, kills):
    """Counts and the differences that were found."""
    reference = Scene(options, scene, settings, ranks, folder + "/undisturbed")
    started = time.time()
    process, _ = reference.start()
    output = process.communicate(timeout=600)[0]
    if process.returncode != 0:
        sys.exit("the undisturbed run failed:\n" + output)
    length = time.time() - started
    expected = history(reference.folder), fields(reference.folder)

    counts = dict(kills=0, writing=0, restarts=0, beginnings=0, ends=0, launchers=0, differences=[])
    while counts["kills"] < kills:
        disturbed = Scene(options, scene, settings, ranks, folder + "/disturbed")
        shutil.rmtree(disturbed.folder, ignore_errors=True)
        while True:
            process, restarted = disturbed.start()
            counts["restarts" if restarted else "beginnings"] += 1
            try:
                # Undisturbed to its end, once there were enough.
                enough = counts["kills"] >= kills
                output = process.communicate(timeout=600 if enough else chance.uniform(0, 1.1 * length))[0]
            except subprocess.TimeoutExpired:
                hung = kill(process, chance)
                if enough:
                    counts["differences"].append("a run did not come to its end")
                    break
                counts["launchers"] += hung == "launcher"
                if hung == "ranks":
                    counts["differences"].append("ranks did not end within a minute of another's death")
                counts["kills"] += 1
                counts["writing"] += half_written(disturbed.folder)
                continue
            counts["ends"] += 1
            if process.returncode != 0:
                counts["differences"].append("exit status %d: %s" % (process.returncode, output))
            elif history(disturbed.folder) != expected[0]:
                counts["differences"].append("history.csv differs")
            elif fields(disturbed.folder) != expected[1]:
                counts["differences"].append("fields.e differs")
            break
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--driver", default=os.path.join(ROOT, "build/release/drivers/ixos"))
    parser.add_argument("--kills", type=int, default=210, help="in all, shared evenly (default: 210)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="scenes whose name contains this")
    options = parser.parse_args()
    chosen = [s for s in scenarios() if options.only in s[0]]
    if not chosen:
        sys.exit('no scene has "%s" in its name' % options.only)
    share = -(-options.kills // len(chosen))
    chance = random.Random(options.seed)
    total = dict(kills=0, writing=0, restarts=0, beginnings=0, ends=0, launchers=0)
    failed = False
    print("| scene | ranks | kills | of them while a checkpoint was written | restarts | starts from the beginning | "
          "runs that came to their end | mpirun hung after its ranks had ended | differences |\n"
          "|---|---|---|---|---|---|---|---|---|", flush=True)
    for name, scene, settings, ranks in chosen:
        with tempfile.TemporaryDirectory(prefix="ixos-kill-") as folder:
            counts = disturb(options, chance, scene, settings, ranks, folder, share)
        differences = counts.pop("differences")
        failed = failed or bool(differences)
        for key in total:
            total[key] += counts[key]
        print("| %s | %d | %s | %s |" % (name, ranks, " | ".join(str(counts[key]) for key in total),
                                         "; ".join(differences) or "none"), flush=True)
    print("| all | | %s | |" % " | ".join(str(value) for value in total.values()))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
