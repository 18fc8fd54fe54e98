#!/usr/bin/python3
"""Full disks, folders that vanish, damaged files: what the driver says, and whether anything goes wrong in silence.

    tests/robustness/damage.py [--driver build/release/drivers/ixos] [--seed 1] [--every 1]

Prints a table in Markdown. The exit status is 1 where something was not noticed, the driver crashed or hung, or a run
that was made whole again did not give the results of an undisturbed one. Full disks are small tmpfs file systems: those
cases need root that may mount, and are left out without. With --every N it tries each N-th size of a disk, cut and
flipped bit.
"""
import argparse
import collections
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import ENVIRONMENT, ROOT, STEPS, driver_command  # noqa: E402
from kill_restart import fields, history  # noqa: E402

BALL = os.path.join(ROOT, "xml/ball.xml")
SETTINGS = [STEPS + "Final Time=0.4", "Output/Fields Interval=20", "Output/Checkpoint/Interval=50", "Output/Checkpoint/Keep=3"]


class Table:
    """Outcomes of cases: how often each exit status, what was said, what was wrong."""

    def __init__(self):
        self.failed = False
        print("| what was tried | times | exit statuses | what was said | gone wrong |\n|---|---|---|---|---|")

    def row(self, name, outcomes, expected):
        """Outcomes are (status, output, problem); `expected` statuses are right."""
        statuses = collections.Counter(status for status, _, _ in outcomes)
        wrong = [problem for _, _, problem in outcomes if problem]
        wrong += ["status %s: %s" % (status, output[-300:]) for status, output, _ in outcomes if status not in expected]
        said = collections.Counter(self.message(output) for _, output, _ in outcomes)
        self.failed = self.failed or bool(wrong)
        print("| %s | %d | %s | %s | %s |" % (
            name, len(outcomes), ", ".join("%s: %d" % item for item in sorted(statuses.items())),
            "; ".join("%s (%d)" % item for item in said.most_common(4)),
            "; ".join(wrong[:3]).replace("\n", " ") if wrong else "nothing"), flush=True)

    @staticmethod
    def message(output):
        """The driver's own line, without what differs from case to case."""
        lines = [line for line in output.splitlines() if line.startswith("ixos:")]
        lines = [line for line in lines if not line.startswith("ixos: warning:")] or lines
        text = re.sub(r"(/[^ :;]*)/", "", lines[0][6:]) if lines else "nothing"
        return re.sub(r"\d[\d.e+-]*", "N", text).replace("|", "/")[:200]


class Driver:
    def __init__(self, path, every=1):
        self.path, self.every = path, every

    def some(self, cases):
        """Returns each `every`-th case, or the first."""
        return cases[::self.every]

    def start(self, arguments, ranks=1, settings=SETTINGS):
        return subprocess.Popen(driver_command(self.path, BALL, arguments, settings, ranks), env=ENVIRONMENT,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def run(self, arguments, **options):
        return finish(self.start(arguments, **options))


def finish(process):
    try:
        output = process.communicate(timeout=120)[0]
        return process.returncode, output
    except subprocess.TimeoutExpired:
        process.kill()
        return "hung", process.communicate()[0]


def differs(folder, reference):
    if history(folder) != history(reference):
        return "history.csv differs"
    return "fields.e differs" if fields(folder) != fields(reference) else ""


def restarted(driver, folder, reference, **options):
    """Goes on where there is a checkpoint, begins anew where there is none; what is wrong with the outcome."""
    link = os.path.join(folder, "checkpoint.h5")
    status, output = driver.run(["--output", folder] + (["--restart", link] if os.path.exists(link) else []), **options)
    return differs(folder, reference) if status == 0 else "the restart ended with %s: %s" % (status, output)


def full_disks(driver, table, work):
    """A run on disks of growing size, then with room again."""
    for ranks, form in ((1, "Exodus"), (2, "Exodus"), (1, "HDF5"), (2, "HDF5")):
        settings = SETTINGS + ["Output/Fields Format=" + form]
        reference = os.path.join(work, "whole-%s-%d" % (form, ranks))
        driver.run(["--output", reference], ranks=ranks, settings=settings)
        disk = os.path.join(work, "disk")
        os.makedirs(disk)
        outcomes = []
        for size in driver.some(range(16, 480, 24)):
            subprocess.run(["mount", "-t", "tmpfs", "-o", "size=%dk" % size, "tmpfs", disk], check=True)
            try:
                folder = os.path.join(disk, "results")
                status, output = driver.run(["--output", folder], ranks=ranks, settings=settings)
                problem = "" if status != 4 or "No space left on device" in output else "no word of the disk: " + output
                subprocess.run(["mount", "-o", "remount,size=20m", disk], check=True)
                outcomes.append((status, output, problem or restarted(driver, folder, reference, ranks=ranks, settings=settings)))
            finally:
                subprocess.run(["umount", disk], check=True)
        os.rmdir(disk)
        table.row("disk full after 16 to 472 KiB, %d rank(s), %s; then room again, restart" % (ranks, form), outcomes, (0, 4))


def limited_files(driver, table, work):
    """No file may grow beyond a limit, set while the run is on its way."""
    for ranks in (1, 2):
        outcomes = []
        for limit in (1, 4, 10, 20, 40):
            folder = os.path.join(work, "limited")
            shutil.rmtree(folder, ignore_errors=True)
            settings = SETTINGS[1:] + [STEPS + "Final Time=1000"]
            process = driver.start(["--output", folder], ranks=ranks, settings=settings)
            wait_for_checkpoint(folder, process)
            for pid in subprocess.run(["pgrep", "-f", folder], capture_output=True, text=True).stdout.split():
                if os.path.exists("/proc/%s/exe" % pid) and os.readlink("/proc/%s/exe" % pid) == os.path.realpath(driver.path):
                    try:
                        resource.prlimit(int(pid), resource.RLIMIT_FSIZE, (limit * 1024, limit * 1024))
                    except (PermissionError, ProcessLookupError):
                        pass  # a rank of the run before, on its way out
            outcomes.append((*finish(process), ""))
        table.row("limit to the size of files (RLIMIT_FSIZE, 1 to 40 KiB), %d rank(s)" % ranks, outcomes, (4,))


def wait_for_checkpoint(folder, process):
    while not os.path.exists(os.path.join(folder, "checkpoint.h5")):
        if process.poll() is not None:
            sys.exit("the run ended early:\n" + process.communicate()[0])
        time.sleep(0.01)


def folders(driver, table, work):
    readonly = os.path.join(work, "readonly")
    os.makedirs(readonly)
    subprocess.run(["mount", "-t", "tmpfs", "-o", "ro", "tmpfs", readonly], check=True)
    try:
        outcomes = [(*driver.run(["--output", os.path.join(readonly, "results")], ranks=ranks), "") for ranks in (1, 2)]
        outcomes += [(*driver.run(["--output", readonly], ranks=ranks), "") for ranks in (1, 2)]
    finally:
        subprocess.run(["umount", readonly], check=True)
    table.row("read-only folder", outcomes, (4,))
    outcomes = []
    for ranks in (1, 2):
        for wait in (0.5, 0.8, 1.1):
            folder = os.path.join(work, "vanishing")
            process = driver.start(["--output", folder], ranks=ranks, settings=SETTINGS[1:] + [STEPS + "Final Time=1000"])
            wait_for_checkpoint(folder, process)
            time.sleep(wait - 0.5)
            while os.path.exists(folder):
                shutil.rmtree(folder, ignore_errors=True)
            outcomes.append((*finish(process), ""))
    table.row("folder deleted during the run", outcomes, (4,))


def damaged_copies(driver, path, chance):
    """Contents of damaged versions: cut at every 4 KiB (and near the ends), bits flipped."""
    with open(path, "rb") as file:
        whole = file.read()
    cuts = sorted({*range(0, len(whole), 4096), 1, 100, 512, len(whole) - 1})
    flips = []
    for place in sorted({*range(0, 64), *(chance.randrange(len(whole)) for _ in range(136))}):
        changed = bytearray(whole)
        changed[place] ^= 1 << chance.randrange(8)
        flips.append(bytes(changed))
    return driver.some([whole[:cut] for cut in cuts]), driver.some(flips)


def copy_afresh(source, folder):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder, symlinks=True)


def checkpoints(folder):
    """The names of a folder's checkpoints, the oldest first."""
    return sorted((name for name in os.listdir(folder) if name.startswith("checkpoint-")), key=lambda n: int(n[11:-3]))


def first_checkpoint(folder):
    return os.path.join(folder, checkpoints(folder)[0])


def damaged_checkpoints(driver, table, work, chance):
    source = os.path.join(work, "whole-1")
    names = checkpoints(source)
    last, before = names[-1], names[-2]
    folder = os.path.join(work, "damaged")
    shutil.copytree(source, folder, symlinks=True)
    for name, copies in zip(("checkpoint cut at every 4 KiB", "checkpoint with a flipped bit"),
                            damaged_copies(driver, os.path.join(source, last), chance)):
        outcomes = []
        for contents in copies:
            with open(os.path.join(folder, last), "wb") as file:
                file.write(contents)
            status, output = driver.run(["--output", folder, "--restart", os.path.join(folder, "checkpoint.h5")])
            problem = "" if "an earlier checkpoint is sound: " in output and before in output else "no offer: " + output
            outcomes.append((status, output, problem))
        table.row(name, outcomes, (2,))
    os.remove(os.path.join(folder, last))
    status, output = driver.run(["--output", folder, "--restart", os.path.join(folder, before)])
    table.row("the one before it, as offered", [(status, output, differs(folder, source))], (0,))
    outcomes = []
    with open(os.path.join(folder, "checkpoint.h5"), "wb") as file:
        file.write(b"")
    for other in ("history.csv", "effective.xml", "fields.e", "checkpoint.h5", "nowhere.h5", "../ball.e"):
        outcomes.append((*driver.run(["--output", folder, "--restart", os.path.join(folder, other)]), ""))
    table.row("restart from a file that is no checkpoint", outcomes, (2,))


def damaged_results(driver, table, work, chance):
    """history.csv and fields.e cut, then a restart into the same folder."""
    source = os.path.join(work, "whole-1")
    folder = os.path.join(work, "cut")
    for name in ("history.csv", "fields.e"):
        length = os.path.getsize(os.path.join(source, name))
        outcomes = []
        for cut in driver.some(sorted({*range(0, length, 4096), length - 1})):
            copy_afresh(source, folder)
            os.truncate(os.path.join(folder, name), cut)
            status, output = driver.run(["--output", folder, "--restart", first_checkpoint(folder)])
            problem = differs(folder, source) if status == 0 else ""
            if status != 0 and os.path.getsize(os.path.join(folder, name)) != cut:
                problem = "a refusal changed the file"
            outcomes.append((status, output, problem))
        table.row("%s cut at every 4 KiB, restart into its folder" % name, outcomes, (0, 2))


def damaged_hdf5_fields(driver, table, work, chance):
    """One HDF5 file of fields, cut and with flipped bits, then a restart into its folder. It has no checksum: numbers of
    frames before may be changed, but nothing may crash."""
    settings = SETTINGS + ["Output/Fields Format=HDF5"]
    for ranks in (1, 2):
        source, folder = (os.path.join(work, "%s-hdf5-%d" % (name, ranks)) for name in ("sound", "changed"))
        driver.run(["--output", source], ranks=ranks, settings=settings)
        whole = history(source)
        for name, copies in zip(("cut at every 4 KiB", "with a flipped bit"),
                                damaged_copies(driver, os.path.join(source, "fields.e"), chance)):
            outcomes = []
            for contents in copies:
                copy_afresh(source, folder)
                with open(os.path.join(folder, "fields.e"), "wb") as file:
                    file.write(contents)
                status, output = driver.run(["--output", folder, "--restart", first_checkpoint(folder)], ranks=ranks,
                                            settings=settings)
                wrong = status == 0 and history(folder) != whole
                outcomes.append((status, output, "history.csv differs" if wrong else ""))
            table.row("fields.e in the HDF5 format %s, restart into its folder, %d rank(s)" % (name, ranks), outcomes, (0, 2))


def damaged_meshes(driver, table, work, chance):
    mesh = os.path.join(work, "ball.e")
    driver.run(["--write-mesh", mesh])
    settings = SETTINGS + ["Mesh/Type=Exodus", "Mesh/Exodus/File=" + os.path.join(work, "damaged.e")]
    shutil.copy(mesh, os.path.join(work, "damaged.e"))
    folder = os.path.join(work, "meshed")
    driver.run(["--output", folder], settings=settings)
    for name, copies in zip(("Exodus mesh cut at every 4 KiB", "Exodus mesh with a flipped bit"),
                            damaged_copies(driver, mesh, chance)):
        for what, arguments, expected in (
                ("checked (no checksum: another valid mesh is taken)", ["--check"], (0, 2)),
                # The fingerprint tells: 0 means that the same mesh was read.
                ("restart of a run with the whole one", ["--check", "--output", folder, "--restart",
                                                         os.path.join(folder, "checkpoint.h5")], (0, 2))):
            outcomes = []
            for contents in copies:
                with open(os.path.join(work, "damaged.e"), "wb") as file:
                    file.write(contents)
                outcomes.append((*driver.run(arguments, settings=settings), ""))
            table.row("%s, %s" % (name, what), outcomes, expected)


def own_mounts():
    """Runs this script anew in a namespace of mounts, which ends with it, even if it is killed. Returns whether it may
    mount."""
    if os.geteuid() != 0:
        return False
    if "IXOS_OWN_MOUNTS" in os.environ:
        return True
    separate = ["unshare", "--mount", "--propagation", "private"]
    if subprocess.run(separate + ["true"], stderr=subprocess.DEVNULL).returncode != 0:
        return False
    os.execvpe(separate[0], separate + [sys.executable] + sys.argv, {**os.environ, "IXOS_OWN_MOUNTS": "1"})


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--driver", default=os.path.join(ROOT, "build/release/drivers/ixos"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="try each N-th case only")
    options = parser.parse_args()
    if options.every < 1:
        parser.error("--every needs a number of at least 1")
    may_mount = own_mounts()
    driver, chance = Driver(options.driver, options.every), random.Random(options.seed)
    with tempfile.TemporaryDirectory(prefix="ixos-damage-") as work:
        for ranks in (1, 2):
            status, output = driver.run(["--output", os.path.join(work, "whole-%d" % ranks)], ranks=ranks)
            if status != 0:
                sys.exit("the undisturbed run failed:\n" + output)
        table = Table()
        if may_mount:
            full_disks(driver, table, work)
            folders(driver, table, work)
        else:
            print("left out: full disks and read-only folders, which need root that may mount", flush=True)
        limited_files(driver, table, work)
        damaged_checkpoints(driver, table, work, chance)
        damaged_results(driver, table, work, chance)
        damaged_hdf5_fields(driver, table, work, chance)
        damaged_meshes(driver, table, work, chance)
    sys.exit(1 if table.failed else 0)


if __name__ == "__main__":
    main()
