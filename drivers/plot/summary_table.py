#!/usr/bin/python3
"""Prints a Markdown table of runs, one row per results folder: status, cost and energy error; for peeling runs also
peak force, detachment, oscillation of the force and its difference from a reference run."""
import argparse

import numpy as np

import measures
import options
from results import ResultsError, Run

SETS = {
    "energy": "scheme,status,end,error,error-initial,error-scale,iterations,iteration,seconds",
    "peeling": "scheme,element,dt,steps,iterations,increment,iteration,peak,peak-time,event,contact,detachment,status",
    "peaks": "scheme,element,dt,start,start-time,snap-off,snap-off-time,detachment",
}

EPILOG = """Examples:
  summary_table.py a.results b.results                              energy errors and cost
  summary_table.py *.results --columns peeling                      peak force, detachment and cost
  summary_table.py *.results --columns scheme,dt,peak --reaction right_y --oscillation 60,100,5
  summary_table.py *.results --columns peeling --reference exact.results --interval 35,60

Names for --columns are those of columns and these sets of columns:
""" + "\n".join(f"  {name:9}{columns}" for name, columns in SETS.items()) + """
A dash stands for a value that is not known. The events go by the contact measure, of which the largest counts: until
half of it is left, peeling starts; the last tenth snaps off. The columns peak and event may therefore compare different
events of several runs; --columns peaks does not.

--oscillation T0,T1,W prints the root mean square, from time T0 to T1, of the force minus its smooth part. The smooth
part at a time t is a parabola fitted to the force from t - W/2 to t + W/2; W should be at least five periods of the
oscillation. The value is a dash if a run does not cover T0 to T1 or has fewer than 5 rows in W. The relative value is
divided by the magnitude of the mean force.

--reference prints the root mean square, over --interval, of the force minus that of the reference run, which is
interpolated linearly to the run's times. The relative value is divided by the root mean square of the reference's
force."""


def count(run, name):
    """A number of summary.json, or NaN."""
    value = run.summary.get(name)
    return np.nan if value is None else value


def peak(run, arguments):
    """Time and size of the largest force; summary.json knows that of steps without a row."""
    name, times, values = run.reaction(arguments.reaction)
    if arguments.until is not None:
        early = times <= arguments.until
        return measures.peak(times[early], values[early]) if early.any() else (np.nan, np.nan)
    time, value = measures.peak(times, values)
    return time, max(value, (run.summary.get("max_force") or {}).get(name) or value)


def event(run, arguments):
    """The event at the largest force; None if that is of a step without a row."""
    time, value = peak(run, arguments)
    _, times, values = run.reaction(arguments.reaction)
    if not value <= values[times == time].max(initial=-np.inf):
        return None
    contact = np.interp(time, run["time"], run["contact_measure"])
    return measures.event(contact, np.nanmax(run["contact_measure"], initial=0.0))


def event_peak(run, arguments, name):
    """Time and size of the largest force in an event."""
    _, times, values = run.reaction(arguments.reaction)
    return measures.event_peak(name, times, values, run["time"], run["contact_measure"])


# Name: (header, format, value of a run).
COLUMNS = {
    "scheme": ("scheme", "", lambda run, _: run.scheme),
    "element": ("contact element", "", lambda run, _: run.element),
    "dt": ("time step", "g", lambda run, _: run.time_step),
    "status": ("status", "", lambda run, _: run.summary.get("status")),
    "end": ("end time", ".4g", lambda run, _: count(run, "end_time")),
    "steps": ("steps", "g", lambda run, _: count(run, "steps")),
    "error": ("max energy error", ".3g", lambda run, _: count(run, "max_energy_error")),
    "error-initial": ("to initial energy", ".3g",
                      lambda run, _: measures.over(count(run, "max_energy_error"), abs(run.initial_energy))),
    "error-scale": ("to energy scale", ".3g", lambda run, choice: count(run, "max_energy_error") / choice.scale),
    "iterations": ("Newton iterations a step", ".2f",
                   lambda run, _: count(run, "newton_iterations") / max(count(run, "steps"), 1)),
    "increment": ("ms an increment", ".4g", lambda run, _: 1e3 * count(run, "seconds_per_increment")),
    "iteration": ("ms an iteration", ".4f",
                  lambda run, _: 1e3 * measures.over(count(run, "wall_seconds"), count(run, "newton_iterations"))),
    "seconds": ("seconds", ".2f", lambda run, _: count(run, "wall_seconds")),
    "peak": ("peak force", ".4g", lambda run, choice: peak(run, choice)[1]),
    "peak-time": ("peak at time", ".4g", lambda run, choice: peak(run, choice)[0]),
    "contact": ("contact at peak", ".4g",
                lambda run, choice: np.interp(peak(run, choice)[0], run["time"], run["contact_measure"])),
    "event": ("event at peak", "", event),
    "start": ("force at the start of peeling", ".4g", lambda run, choice: event_peak(run, choice, "start of peeling")[1]),
    "start-time": ("start of peeling", ".4g", lambda run, choice: event_peak(run, choice, "start of peeling")[0]),
    "snap-off": ("force at the snap-off", ".4g", lambda run, choice: event_peak(run, choice, "snap-off")[1]),
    "snap-off-time": ("snap-off", ".4g", lambda run, choice: event_peak(run, choice, "snap-off")[0]),
    "detachment": ("detachment time", ".4g", lambda run, _: measures.detachment(run["time"], run["contact_measure"])),
}


def column_names(text):
    """The type of --columns: sets and names, separated by commas."""
    names = [name for word in text.split(",") for name in SETS.get(word, word).split(",")]
    for name in names:
        if name not in COLUMNS:
            raise argparse.ArgumentTypeError(f"unknown column '{name}'; allowed: {', '.join([*SETS, *COLUMNS])}")
    return names


def cell(value, form):
    """A value as text; a dash where there is none."""
    return "-" if value is None or (form and np.isnan(value)) else format(value, form)


def main():
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="a results folder (with history.csv)")
    parser.add_argument("--columns", type=column_names, default="energy", metavar="NAME,...",
                        help="columns or sets of columns (default: %(default)s)")
    parser.add_argument("--scale", type=options.positive, default=0.1549567, help="energy that the column "
                        "error-scale is divided by (default: work of adhesion times diameter of xml/ball.xml, "
                        "%(default)s E0 L0^2)")
    parser.add_argument("--reaction", metavar="NAME", help="column of the force (default: the first reaction_*_y, in "
                        "3D _z)")
    parser.add_argument("--until", type=options.positive, metavar="T", help="take the peak up to this time only, to "
                        "get the peak at the start of peeling rather than at the snap-off")
    parser.add_argument("--oscillation", type=options.oscillation, metavar="T0,T1,W",
                        help="add the oscillation of the force (see below)")
    parser.add_argument("--reference", metavar="FOLDER",
                        help="add the error of the force relative to this run (see below)")
    parser.add_argument("--interval", type=options.interval, metavar="T0,T1",
                        help="times of the comparison with --reference (default: all that both runs have)")
    arguments = parser.parse_args()
    if arguments.interval and not arguments.reference:
        parser.error("--interval needs --reference")

    header = [COLUMNS[name][0] for name in arguments.columns]
    rows = []
    if arguments.oscillation:
        header += ["force oscillation", "relative"]
    if arguments.reference:
        header += ["force error", "relative"]
        exact = Run(arguments.reference).reaction(arguments.reaction)[1:]
        if arguments.interval and not measures.covered(exact[0], arguments.interval):
            raise ResultsError(f"{arguments.reference} does not cover the times from {arguments.interval[0]:g} to "
                               f"{arguments.interval[1]:g}")
    for run in map(Run, arguments.folders):
        row = [cell(value(run, arguments), form) for _, form, value in map(COLUMNS.get, arguments.columns)]
        if arguments.oscillation or arguments.reference:
            force = run.reaction(arguments.reaction)[1:]
        if arguments.oscillation:
            row += [cell(value, ".3g") for value in measures.oscillation(*force, *arguments.oscillation)]
        if arguments.reference:
            row += [cell(value, ".3g") for value in measures.deviation(*force, *exact, arguments.interval)]
        rows.append(row)
    for cells in [header, ["---"] * len(header)] + rows:
        print("| " + " | ".join(cells) + " |")


if __name__ == "__main__":
    options.run(main)
