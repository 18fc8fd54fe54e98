"""Runs that are killed, faults that are injected, files that are damaged; and what checkpoints cost."""
import collections
import re

from ..bodies import MECHANICS
from ..runs import FINAL_TIME, Failure, interleaved, markdown_rows
from ..table import Column, Table

PAGE = "docs/results/robustness.md"
# These folders write what a run keeps, and resume it.
KEPT = ("drivers/ixos", "lib/checkpoint", "lib/io", "lib/run", "lib/scene", "lib/solve", "lib/time")


def printed(context, script, *arguments):
    """Runs a script of tests/robustness. Returns the rows of its table. The script ends with 1 if one is bad: the table
    shows it, but a trial fails. Raises Failure if the script broke off, or leaves cases out in more than a trial."""
    text = context.run_text(f"tests/robustness/{script}", *arguments, "--driver", context.program("ixos"),
                            allowed=(0,) if context.trial else (0, 1))
    left_out = re.search("^left out: .*", text, re.MULTILINE)
    if left_out and not context.trial:
        raise Failure(f"{script}: {left_out[0]}")
    rows = markdown_rows(text)
    errors = (context.folder / "stderr").read_text(encoding="utf-8", errors="replace")
    if not rows or re.search("Traceback|undisturbed run|the run ended early", errors):
        raise Failure(f"{script} broke off: {''.join(errors.splitlines()[-1:])}")
    return rows


KILLS = {"kills": "kills", "of them while a checkpoint was written": "while a checkpoint was written",
         "restarts": "restarts", "starts from the beginning": "starts from the beginning",
         "mpirun hung after its ranks had ended": "mpirun hung after its ranks had ended"}


def measure_kills(context):
    """Kills runs at random moments. Sums those of one rank and of two."""
    rows = collections.defaultdict(collections.Counter)
    for line in printed(context, "kill_restart.py", "--seed", 2,
                        *context.pick(("--kills", 40), ("--kills", 1, "--only", "ball, HDF5"))):
        if line["scene"] == "all":
            continue
        for name in (line["scene"], "all"):
            rows[name].update({head: int(line[head]) for head in KILLS}, differences=int(line["differences"] != "none"))
    rows["all"] = rows.pop("all")  # it comes last
    return [{"scene": scene, **row} for scene, row in rows.items()]


FAULTS = {"open": "open, close", "close": "open, close", "read": "read", "short_read": "short read or write",
          "short_write": "short read or write", "write": "write, disk full", "full": "write, disk full", "sync": "sync",
          "rename": "rename, truncate, remove", "truncate": "rename, truncate, remove",
          "remove": "rename, truncate, remove", "allocate": "allocation", "mpi": "MPI call"}
ENDS = {"faults": "faults", "bad end": "bad end", "bad restart": "bad restart", "no effect": "no effect",
        "exit status 2": "status 2", "exit status 3": "status 3", "exit status 4": "status 4",
        "same": "restarts: same", "no checkpoint": "no checkpoint yet", "results refused": "results refused"}


def measure_faults(context):
    """Lets calls fail. Sums the scenes of the ball, on one rank and on two."""
    lines = printed(context, "faults.py", "--every", "none", "--most", 1, "--most-allocations", 2, "--only",
                    context.pick("ball", "ball, HDF5 frames, rank 0"), "--injector",
                    context.program("libfault_injector.so"), *context.pick((), ("--kinds", "write,sync")))
    rows = collections.defaultdict(collections.Counter)
    for line in lines:
        for name in (FAULTS[line["kind"]], "all"):
            rows[name].update({end: int(line[end]) for end in ENDS})
    return [{"call": name, **rows[name]} for name in [*dict.fromkeys(FAULTS.values()), "all"] if name in rows]


def measure_damage(context):
    """Damages files, and takes the disk or the folder away. Sums ranks, formats of frames, cuts and flipped bits."""
    rows = collections.defaultdict(collections.Counter)
    for line in printed(context, "damage.py", "--every", context.pick(4, 100)):
        name = re.sub(r", \d rank\(s\)(, (Exodus|HDF5))?", "", line["what was tried"])
        name = re.sub("cut at every 4 KiB|with a flipped bit", "damaged", name)
        rows[name].update(cases=int(line["times"]), wrong=int(line["gone wrong"] != "nothing"))
        rows[name].update({status: int(times) for status, times in
                           (entry.split(": ") for entry in line["exit statuses"].split(", "))})
    return [{"damage": name, **{status: 0 for status in "024"}, **row} for name, row in rows.items()]


# The settings of checkpoints, and whether the run writes any.
CHECKPOINTS = {"none": [], "every 100 steps": ["Output/Checkpoint/Interval=100"],
               "every step": ["Output/Checkpoint/Interval=1"]}


def measure_checkpoints(context):
    """Compares runs of the strip with and without checkpoints."""
    return [row for ranks in context.pick((1, 2), (1,)) for row in compare_checkpoints(context, ranks)]


def compare_checkpoints(context, ranks):
    """Returns the rows of so many ranks."""
    def numbers(name):
        summary = context.run("strip", ["Output/Fields Time Interval=0", f"{FINAL_TIME}={context.pick(20, 1)}",
                                        *CHECKPOINTS[name]], ranks, name, frames=name != "none")
        return {"seconds": summary["wall_seconds"], "steps": summary["steps"]}

    samples = interleaved(CHECKPOINTS, context.pick(3, 1), numbers)
    none, every = samples["none"], samples["every step"]
    cost = (every.ratio["seconds"] - 1) * none.median["seconds"] / none.median["steps"]
    size = (context.folder / "every step/checkpoint.h5").stat().st_size
    return [{"checkpoints": name, "ranks": ranks, "time": sample.ratio["seconds"], "seconds": sample.median["seconds"],
             **({"ms": 1e3 * cost, "MB": size / 1e6} if name == "every step" else {})}
            for name, sample in samples.items()]


TABLES = [
    Table(name="robustness-kills", page=PAGE, code=KEPT, minutes=3,
          measure=measure_kills,
          columns=[Column("scene, on one rank and on two", key="scene"),
                   Column("series with a difference", key="differences"),
                   *(Column(title, key=head) for head, title in KILLS.items())]),
    Table(name="robustness-faults", page=PAGE, minutes=5, needs=("fault_injector",), measure=measure_faults,
          code=(*KEPT, "tests/robustness/fault_injector.cpp"),
          columns=[Column("call that fails", key="call"), *(Column(title, key=end) for end, title in ENDS.items())]),
    Table(name="robustness-damage", page=PAGE, code=(*KEPT, "tests/robustness/kill_restart.py"), minutes=3,
          measure=measure_damage,
          columns=[Column("damage"), Column("cases"), Column("series gone wrong", key="wrong"), Column("status 0", key="0"),
                   Column("status 2", key="2"), Column("status 4", key="4")]),
    Table(name="robustness-checkpoints", page=PAGE, code=(*MECHANICS, "lib/checkpoint"), minutes=1.2,
          measure=measure_checkpoints,
          columns=[Column("checkpoints"), Column("ranks"), Column("time to none", "{:.3f}", "time"),
                   Column("ms a checkpoint", "{:.1f}", "ms"), Column("MB a checkpoint", "{:.1f}", "MB"),
                   Column("s", "{:.2f}", "seconds")]),
]
