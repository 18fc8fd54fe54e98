#!/usr/bin/env python3
"""How the spatula and the block scale: strong and weak scaling, messages, and a model of many ranks, as Markdown.

usage: scaling.py BUILD [--only strong weak messages model] [--cells N] [--block N] [--ranks N...] [--steps N]

strong    one body on more ranks; seconds a Newton iteration by phase
weak      the same cells a rank: a longer block, a finer spatula
messages  what a rank sends in a Newton iteration (mean, largest), counted: the difference of a run of 2 N and of N steps
model     seconds a Newton iteration on up to 1024 ranks, from the times of one rank and the messages of the most ranks

Times need an idle machine with as many cores as ranks; what is counted does not.
"""
import argparse
import json
import os
import tempfile

import scaling_model
from newton_times import COLUMNS, block, figures, header, row, run, spatula

REDUCTIONS = ("allreduce", "reduce", "scan", "barrier")
OTHERS = ("broadcast", "gather", "allgather", "alltoall")
# What `Automatic` takes for a large block; a small one may count as slender.
MULTIGRID = ["Linear Solver/Linear Solver Type=Belos", "Linear Solver/Preconditioner Type=MueLu",
             "Linear Solver/Operator=Matrix-Free"]


def bodies(arguments, ranks=1, steps=None):
    """Name, scene and settings of the bodies with the cells of so many ranks; the block doubles by turns in x, y and z."""
    steps = steps or arguments.steps
    divisions = [arguments.block] * 3
    for doubling in range(ranks.bit_length() - 1):
        divisions[doubling % 3] *= 2
    scene, settings = block(divisions, steps)
    return [("spatula", *spatula(arguments.cells * ranks, steps)), ("block", scene, settings + MULTIGRID)]


def strong(arguments):
    """One body on more ranks."""
    header("body", "degrees of freedom", "ranks", *COLUMNS, "speed-up")
    for name, scene, settings in bodies(arguments):
        first = None
        for ranks in arguments.ranks:
            result = run(arguments.build, scene, settings, ranks)
            seconds = result["wall_seconds"] / result["newton_iterations"]
            first = first or seconds
            row(name, f'{result["dofs"]:,}', ranks, *figures(result), f"{first / seconds:.2f}")


def weak(arguments):
    """The same cells on each rank."""
    header("body", "degrees of freedom", "ranks", *COLUMNS, "efficiency")
    first = {}
    for ranks in arguments.ranks:
        for name, scene, settings in bodies(arguments, ranks):
            result = run(arguments.build, scene, settings, ranks)
            seconds = result["wall_seconds"] / result["newton_iterations"]
            efficiency = first.setdefault(name, seconds) / seconds
            row(name, f'{result["dofs"]:,}', ranks, *figures(result), f"{efficiency:.2f}")


def counted(build, scene, settings, ranks):
    """The summary of a run, and what each rank sent."""
    library = os.path.abspath(f"{build}/tests/libmessage_counter.so")
    with tempfile.NamedTemporaryFile() as file:
        result = run(build, scene, settings, ranks, [f"LD_PRELOAD={library}", f"MESSAGE_COUNTS={file.name}"])
        return result, json.load(file)


def messages_of(arguments, body, ranks):
    """Of the body of that number: CG iterations a Newton iteration, and by kind a list by rank, a Newton iteration."""
    runs = [counted(arguments.build, *bodies(arguments, steps=steps)[body][1:], ranks)
            for steps in (arguments.steps, 2 * arguments.steps)]
    (short, before), (long, after) = runs
    newton = long["newton_iterations"] - short["newton_iterations"]
    counts = {kind: [(b - a) / newton for a, b in zip(before[kind], after[kind])] for kind in before}
    return (long["linear_iterations"] - short["linear_iterations"]) / newton, counts, long["dofs"]


def total(counts, kinds, what):
    """Of several kinds of calls, their mean over the ranks."""
    return sum(sum(counts[f"{kind} {what}"]) / len(counts[f"{kind} {what}"]) for kind in kinds)


def messages(arguments):
    """What a rank sends, a Newton iteration."""
    header("body", "degrees of freedom", "ranks", "CG/Newton", "messages", "of the rank with most", "kB", "of the rank with most",
           "reductions", "kB reduced", "other collective calls", "kB in them")
    for body, (name, _, _) in enumerate(bodies(arguments)):
        for ranks in (n for n in arguments.ranks if n > 1):
            linear, counts, dofs = messages_of(arguments, body, ranks)
            sends, sent = counts["send calls"], counts["send bytes"]
            row(name, f"{dofs:,}", ranks, f"{linear:.1f}", f"{sum(sends) / ranks:.0f}", f"{max(sends):.0f}",
                f"{sum(sent) / ranks / 1e3:.0f}", f"{max(sent) / 1e3:.0f}", f'{total(counts, REDUCTIONS, "calls"):.0f}',
                f'{total(counts, REDUCTIONS, "bytes") / 1e3:.1f}', f'{total(counts, OTHERS, "calls"):.0f}',
                f'{total(counts, OTHERS, "bytes") / 1e3:.1f}')


def model(arguments):
    """Seconds on many ranks."""
    print(f"Latency {scaling_model.LATENCY * 1e6:g} us, {scaling_model.BANDWIDTH / 1e9:g} GB/s a rank, at most "
          f"{scaling_model.FRONT_RANKS} ranks a front; milliseconds a Newton iteration:\n")
    header("body", "degrees of freedom", "ranks", *scaling_model.PHASES, "in all", "efficiency")
    most = max(arguments.ranks)
    for body, (name, scene, settings) in enumerate(bodies(arguments)):
        result = run(arguments.build, scene, settings, 1)
        newton = result["newton_iterations"]
        one = {phase: seconds / newton for phase, seconds in result["seconds"].items()}
        one["nodes"] = result["dofs"] / 3
        _, counts, _ = messages_of(arguments, body, most)
        sent = {"messages": max(counts["send calls"]), "bytes": max(counts["send bytes"]),
                "reductions": total(counts, REDUCTIONS + OTHERS, "calls")}
        slender = name == "spatula"  # and so MUMPS' factorisation is the default
        width = arguments.width * (one["nodes"] / 134e3) ** (2 / 3) if slender else 0
        first = None
        for ranks in (1, 4, 16, 64, 256, 1024):
            times = scaling_model.times(one, sent, most, ranks, slender, width)
            seconds = sum(times.values())
            first = first or seconds
            row(name, f'{result["dofs"]:,}', ranks, *(f"{1e3 * value:.2f}" for value in times.values()),
                f"{1e3 * seconds:.2f}", f"{first / seconds / ranks:.2f}")


def main():
    parts = {"strong": strong, "weak": weak, "messages": messages, "model": model}
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--only", nargs="+", choices=parts, default=list(parts))
    parser.add_argument("--cells", type=int, default=28600, help="of the spatula, of one rank where it is weak scaling")
    parser.add_argument("--block", type=int, default=24, help="cells of the block's edge, likewise")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2, 4])
    parser.add_argument("--steps", type=int, default=4)
    parser.add_argument("--width", type=float, default=500, help="nodes of a separator of the full spatula, for the model")
    arguments = parser.parse_args()
    for part in arguments.only:
        print(f"\n{parts[part].__doc__}\n", flush=True)
        parts[part](arguments)


if __name__ == "__main__":
    main()
