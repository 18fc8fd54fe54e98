"""Counts what the ranks of a run send, with the library message_counter, which is loaded before MPI."""
import dataclasses
import json

from .runs import NO_FRAMES, ROOT, driver_command

# Ranks that wait yield, so that more of them than cores do not starve each other. Counts stay the same.
YIELDING = {"OMPI_MCA_mpi_yield_when_idle": "1"}
REDUCTIONS = ("allreduce", "reduce", "scan", "barrier")
OTHERS = ("broadcast", "gather", "allgather", "alltoall")


@dataclasses.dataclass(frozen=True)
class Counts:
    """What ranks send in a Newton iteration: lists by rank of messages and of their bytes, from point to point; means
    over the ranks of calls and bytes of collective operations; iterations of CG; degrees of freedom."""
    messages: list
    sent: list
    reductions: float
    others: float
    collective_bytes: float
    linear: float
    dofs: int


def count(context, short, long, ranks):
    """Returns the Counts of two runs on several ranks that differ in the number of steps.

    short, long: scene (a name of xml/ or a path) and settings. The difference of the runs is what the later steps send,
    without the start of the program."""
    (first, before), (last, after) = (counted(context, *body, ranks) for body in (short, long))
    newton = last["newton_iterations"] - first["newton_iterations"]
    found = {kind: [(late - early) / newton for early, late in zip(before[kind], after[kind])] for kind in before}

    def mean(kinds, what):
        return sum(sum(found[f"{kind} {what}"]) for kind in kinds) / ranks

    return Counts(found["send calls"], found["send bytes"], mean(REDUCTIONS, "calls"), mean(OTHERS, "calls"),
                  mean(REDUCTIONS + OTHERS, "bytes"),
                  (last["linear_iterations"] - first["linear_iterations"]) / newton, last["dofs"])


def counted(context, scene, settings, ranks):
    """Returns the summary of a run, and what the library counted in it."""
    counts = context.folder / "counts.json"
    path = ROOT / scene if "/" in scene else ROOT / f"xml/{scene}.xml"
    launcher, *rest = driver_command(str(context.program("ixos")), str(path),
                                     ["--overwrite", "--output", str(context.folder / "counted")],
                                     [*settings, *NO_FRAMES], ranks)
    # Open MPI passes the variables to the ranks only: mpirun itself is no MPI program.
    context.execute([launcher, "-x", f"LD_PRELOAD={context.program('libmessage_counter.so')}",
                     "-x", f"MESSAGE_COUNTS={counts}", *rest], variables=YIELDING)
    return context.summary("counted"), json.loads(counts.read_text(encoding="utf-8"))
