"""The table of the costs of a scene's options: the strip, one option switched at a time."""
import statistics

from ..bodies import MECHANICS
from ..runs import forms
from ..table import Column, Table

BASE = "as it is"
OPTIONS = [BASE, "Exodus frame every step", "damping", "viscosity", "one Maxwell branch", "linear elastic",
           "quadratic cells, the same nodes", "no inertia", "cutoff at 2 L0", "Morse", "sphere of radius 1e5 L0",
           "friction", "Q1C4", "cells of twice the size, refined at the foot", "guided by a plane of symmetry",
           "two stages"]
STUDY = forms.ShortStudy({}, {"Option": OPTIONS}, {})


def measure(context):
    """A round of the study has all options, so ratios are those within a round."""
    rounds = {}
    for run in context.study("strip-options-study", STUDY).runs.values():
        rounds.setdefault(run["Round"], {})[run["Option"]] = run

    def ratio(option, cost, count):
        return statistics.median(runs[option][cost] / runs[option][count] / (runs[BASE][cost] / runs[BASE][count])
                                 for runs in rounds.values())

    rows = []
    for option in OPTIONS:
        run = next(iter(rounds.values()))[option]
        rows.append({"option": option, "a step, to the first": ratio(option, "cpu_seconds", "steps"),
                     "an iteration, to the first": ratio(option, "cpu_seconds", "newton_iterations"),
                     "iterations a step": run["newton_iterations"] / run["steps"],
                     "memory, MB": run["peak_memory_bytes"] / 1e6, "change of the force": run["error_force"]})
    return rows


TABLES = [
    Table("strip-options", "docs/results/strip.md",
          [Column("option"), Column("a step, to the first", "{:.2f}"), Column("an iteration, to the first", "{:.2f}"),
           Column("iterations a step", "{:.2f}"), Column("memory, MB", "{:.0f}"),
           Column("change of the force", "{:.1g}")],
          measure, (*MECHANICS, "lib/run", "lib/io", "xml/strip.xml", "xml/strip-options-study.xml"),
          minutes=2.7),
]
