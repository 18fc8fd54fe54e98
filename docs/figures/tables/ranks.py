"""Several ranks: how times scale, and what ranks send."""
from .. import bodies, messages, pair_scenes
from ..bodies import MECHANICS, iterative
from ..runs import FINAL_TIME, SCHEME, TIME_STEP, interleaved
from ..table import Column, Table

PAGE = "docs/results/ranks.md"
STRIP = [f"{SCHEME}=Newmark", f"{TIME_STEP}=1", f"{FINAL_TIME}=30", "Interactions/Wall/Contact Element=Q1C4"]


def block(edges, steps, preconditioner):
    """Returns scene and settings of a block with a preconditioner. By itself a small one may count as slender."""
    scene, settings = bodies.block(edges, steps)
    return scene, settings + iterative(preconditioner, "Matrix-Free")


def spatula(cells, steps):
    """Returns scene and settings of the spatula with the solver that a large one takes by itself."""
    scene, settings = bodies.spatula(cells, steps)
    return scene, settings + iterative("Direct", "Matrix-Free", "MUMPS Single")


def doubled(edge, ranks):
    """Returns the edges of a block with the cells of so many ranks: it doubles by turns along x, y and z."""
    edges = [edge] * 3
    for doubling in range(ranks.bit_length() - 1):
        edges[doubling % 3] *= 2
    return edges


def measure_scaling(context):
    """Compares two ranks with one: on the same body, and on a body of twice as many cells."""
    cells, edge = context.pick((28600, 24), (1500, 8))
    cases = {"strip, Band": lambda ranks: ("strip", STRIP),
             "spatula, MUMPS": lambda ranks: spatula(ranks * cells, 4),
             "block, Two-Level": lambda ranks: block(doubled(edge, ranks), 4, "Two-Level")}
    rows = []
    for name, body in cases.items():
        variants = [(1, 1), (1, 2)] + ([(2, 2)] if name != "strip, Band" else [])
        rows += compare_ranks(context, name, body, variants[:context.pick(3, 1)])
    return rows


def compare_ranks(context, name, body, variants):
    """Returns the rows of a body; variants: how many times its cells, and ranks."""
    def numbers(variant):
        scale, ranks = variant
        summary = context.run(*body(scale), ranks)
        return bodies.per_iteration(summary) | {"dofs": summary["dofs"]}

    samples = interleaved(variants, context.pick(3, 1), numbers)
    return [{"body": name, "cells": "twice" if scale == 2 else "the same", "ranks": ranks,
             "time": sample.ratio["seconds"], **sample.median, "dofs": int(sample.median["dofs"])}
            for (scale, ranks), sample in samples.items()]


def measure_messages(context):
    """Counts what a rank sends in a Newton iteration. Counts do not depend on the machine."""
    cells, ranks = context.pick(((12, 6), 4), ((5, 2), 2))
    cases = {"spatula, MUMPS": lambda steps: spatula(1000, steps),
             "block, MueLu": lambda steps: block([10] * 3, steps, "MueLu"),
             **{name: lambda steps, name=name: pair_scenes.body(context, name, cells, steps)
                for name in pair_scenes.SCENES}}
    rows = []
    for name, body in cases.items():
        counts = messages.count(context, body(2), body(4), ranks)
        rows.append({"body": name, "ranks": ranks, "messages": sum(counts.messages) / ranks,
                     "most messages": max(counts.messages), "kB": sum(counts.sent) / ranks / 1e3,
                     "most kB": max(counts.sent) / 1e3, "reductions": counts.reductions, "others": counts.others,
                     "collective kB": counts.collective_bytes / 1e3, "CG": counts.linear, "dofs": counts.dofs})
    return rows


COUNTED = ("docs/figures/messages.py", "tests/bench/message_counter.cpp")
DOFS = Column("degrees of freedom", "{:,}", "dofs")
TABLES = [
    Table(name="ranks-scaling", page=PAGE, code=MECHANICS, minutes=1.5, measure=measure_scaling,
          columns=[Column("body"), Column("cells"), Column("ranks"),
                   Column("time of an iteration to one rank", "{:.2f}", "time"), DOFS, *bodies.COLUMNS]),
    Table(name="ranks-messages", page=PAGE, minutes=1, needs=("message_counter",), measure=measure_messages,
          code=(*MECHANICS, *COUNTED, "docs/figures/pair_scenes.py"),
          columns=[Column("body"), Column("ranks"), Column("messages", "{:.0f}"),
                   Column("of the rank with most", "{:.0f}", "most messages"), Column("kB", "{:.0f}"),
                   Column("of the rank with most", "{:.0f}", "most kB"), Column("reductions", "{:.0f}"),
                   Column("other collective calls", "{:.1f}", "others"),
                   Column("kB in collective calls", "{:.1f}", "collective kB"),
                   Column("CG iterations", "{:.1f}", "CG"), DOFS]),
]
