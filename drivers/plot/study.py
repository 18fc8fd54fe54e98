#!/usr/bin/python3
"""Draws error over cost for the runs of a study, one picture per measure of error, and writes report.html, a single
file that needs no other."""
import itertools
import math
import textwrap

from matplotlib.ticker import LogLocator

import options
import style
from peeling import note
from results import ResultsError
from study_report import write_report
from study_results import COSTS, ERRORS, Study, file_name
from style import plt

EPILOG = """Examples:
  study.py ball.study     -> ball.study/work-precision-energy.png, .svg, ...; ball.study/report.html

The script reads study.csv and study.json, which ixos-study writes. A line joins runs that differ only in the axis
Question/Connect of the study; it breaks at runs that did not reach their end. Crosses above a plot are runs that
failed, at the cost up to the failure. Points on the bottom edge have errors below 1e-17. Rings mark the Pareto set: no
other run is better in both cost and error."""

MARKERS = "os^Dvp<>h"  # fewer than colours, so that the two together repeat late
STROKES = [{"linestyle": "-"}, {"linestyle": (0, (4, 2)), "markerfacecolor": "white"},
           {"linestyle": (0, (1, 1.4)), "fillstyle": "left"}, {"linestyle": "-.", "fillstyle": "bottom"}]
MARKS = {
    "Pareto set": {"marker": "o", "markersize": 10, "markerfacecolor": "none", "markeredgecolor": style.INK,
                   "markeredgewidth": 0.8, "color": "#C9C9C9", "linewidth": 3.5, "drawstyle": "steps-post"},
    "recommended": {"marker": "o", "markersize": 14, "markerfacecolor": "none", "markeredgecolor": style.INK,
                    "markeredgewidth": 1.8, "linestyle": "none"},
    "tolerance": {"color": style.INK, "linewidth": 0.9, "linestyle": (0, (6, 3))},
    "reference's own error": {"color": style.INK, "linewidth": 0.9, "linestyle": (0, (1, 2))},
    "failed": {"marker": "x", "markersize": 5, "markeredgewidth": 1.3, "color": style.INK, "linestyle": "none"},
}
NOTHING = {"linestyle": "none"}
WIDTH, HEIGHT, ROW = 5.8, 4.2, 0.17  # inches: the plot, and a row of crosses above it
LETTER, SMALL = 0.065, 6.5  # inches a letter of a small label takes; points of its font
LEAST = 1e-17  # smaller errors stand on the bottom edge
FEW = 4  # lines up to which every point has its label; of more lines, only those of the Pareto set


def plain(text, width=34):
    """Text that matplotlib shows as it is, in lines of so many letters."""
    text = "\n".join(textwrap.wrap(text, width)).replace("$", r"\$")
    return f" {text}" if text[:1] in ("", "_") else text  # legends skip what begins with _


def look(number, stroke, **other):
    """How the line of a colour's and a stroke's number is drawn."""
    return {"color": style.COLORS[number % len(style.COLORS)], "marker": MARKERS[number % len(MARKERS)], "markersize": 4.5,
            "linewidth": 1.1, "markerfacecoloralt": "white", **STROKES[stroke % len(STROKES)], **other}


def looks(study):
    """Looks of the lines by name, and what the legend says of them, as (text, look; None for a heading): the longest
    axis tells colour and marker, the others together tell dash and filling."""
    main = max(study.varying, key=lambda axis: len(study.axes[axis]), default=None)
    others = [axis for axis in study.varying if axis != main]
    colors, strokes = study.axes.get(main, [""]), list(itertools.product(*(study.axes[axis] for axis in others)))
    result = {}
    for name in study.lines:
        here = dict(zip(study.varying, name))
        result[name] = look(colors.index(here.get(main, "")), strokes.index(tuple(here[axis] for axis in others)))
    legend = [(main, None)] + [(text, look(number, 0)) for number, text in enumerate(colors)] if main else []
    if others:
        legend += [(", ".join(others), None)]
        legend += [(", ".join(words), look(0, number, color=style.INK)) for number, words in enumerate(strokes)]
    return result, legend


def limits(values, margin):
    """Limits of a logarithmic axis around values."""
    low, high = min(values), max(values)
    factor = max((high / low) ** margin, 1.5)
    return low / factor, high * factor


def set_scale(axis, low, high):
    """A logarithmic axis with these limits; numbers at 1, 2, 3, 5 where decades are few."""
    axis.axes.set(**{f"{axis.axis_name}scale": "log", f"{axis.axis_name}lim": (low, high)})
    if high < 100 * low:
        axis.set_major_locator(LogLocator(subs=(1, 2, 3, 5)))
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter("")


def draw_failures(axes, lines, shown, study):
    """A row of crosses for each line that has failed runs, with the runs' labels, those of near crosses together."""
    left, right = (math.log10(limit) for limit in axes.get_xlim())
    for row, name in enumerate(lines):
        groups = []  # (crosses' places in inches, labels)
        for run in sorted(study.failed(name), key=study.cost):
            place = WIDTH * (math.log10(max(study.cost(run), 10 ** left)) - left) / (right - left)
            if not groups or place > groups[-1][0][-1] + 0.1 + LETTER * len(", ".join(groups[-1][1])):
                groups.append(([], []))
            groups[-1][0].append(place)
            groups[-1][1].append(study.label(run))
        for places, labels in groups:
            x = [10 ** (left + place / WIDTH * (right - left)) for place in places]
            axes.plot(x, [row] * len(x), clip_on=False, **{**MARKS["failed"], "color": shown[name]["color"]})
            text = ", ".join(filter(None, labels))
            outside = places[-1] + 0.1 + LETTER * len(text) > WIDTH
            note(axes, plain(text), (x[0 if outside else -1], row), (-5 if outside else 5, -0.5), fontsize=SMALL,
                 ha="right" if outside else "left", va="center")
    axes.set(ylim=(len(lines) - 0.4, -0.6), facecolor="#F4F4F4", yticks=range(len(lines)),
             yticklabels=[plain(", ".join(name)).replace("\n", " ") for name in lines])
    axes.set_ylabel("failed", rotation=0, ha="right", va="center")
    axes.tick_params(axis="y", labelsize=SMALL, length=0, labelleft=False, labelright=True)
    axes.tick_params(axis="x", which="both", length=0, labelbottom=False)
    axes.grid(False, axis="y")
    axes.spines[:].set_visible(False)


def write_labels(axes, below, above):
    """Labels (text, place) left below their points or right above, as far as they do not cover each other."""
    taken = []
    for side, (text, (x, y)) in [(-1, label) for label in below] + [(1, label) for label in above]:
        rise = 1 if y[0] <= axes.get_ylim()[0] else side  # none below the bottom edge
        across, up = (axes.transData.transform((x[0], y[0])) / axes.figure.dpi).tolist()
        middle = across + side * (0.08 + LETTER * len(text) / 2), up + rise * 0.12
        if any(abs(middle[0] - other[0]) < LETTER * (len(text) + length) / 2 and abs(middle[1] - other[1]) < 0.1
               for *other, length in taken):
            continue
        taken.append((*middle, len(text)))
        note(axes, plain(text), (x[0], y[0]), (6 * side, 5 * rise), fontsize=SMALL, ha="left" if side > 0 else "right",
             va="bottom" if rise > 0 else "top")


def write_legend(axes, entries):
    """A legend at the right of (text, look; None for a heading)."""
    legend = axes.legend([plt.Line2D([], [], **(shape or NOTHING)) for _, shape in entries],
                         [plain(text) for text, _ in entries], loc="upper left", bbox_to_anchor=(1.01, 1),
                         borderaxespad=0, handlelength=2.4, labelspacing=0.55)
    for (_, shape), text in zip(entries, legend.get_texts()):
        text.set_weight("normal" if shape else "bold")


def draw(study, measure):
    """The figure of a measure."""
    shown, entries = looks(study)
    failed = [name for name in study.lines if study.failed(name)]
    tolerance = study.data["tolerance"] if measure == study.data["measure"] else None
    there = [run for run in study.runs.values() if not math.isnan(study.error(run, measure))]
    costs = [study.cost(run) for run in there + [run for name in failed for run in study.failed(name)]]
    height = HEIGHT + ROW * len(failed)
    figure = plt.figure(figsize=(WIDTH, height))
    axes = top = figure.add_axes((0, 0, 1, HEIGHT / height))
    set_scale(axes.xaxis, *limits([cost for cost in costs if cost > 0] or [1], 0.07))
    set_scale(axes.yaxis, *limits([error for run in there if (error := study.error(run, measure)) >= LEAST] +
                                  ([tolerance] if tolerance else []) or [LEAST], 0.07))
    left, bottom = axes.get_xlim()[0], axes.get_ylim()[0]

    def points(runs):
        """Places of runs, not a number where one has none."""
        errors = [math.nan if run is None else study.error(run, measure) for run in runs]
        return ([math.nan if run is None else max(left, study.cost(run)) for run in runs],
                [bottom if error < LEAST else error for error in errors])

    front = [run for run in study.pareto[measure] if run in there]
    best = [study.best] if study.best in there else []
    if tolerance:
        axes.axhline(tolerance, zorder=1.5, **MARKS["tolerance"])
    own = study.own_error(measure) >= bottom
    if own:
        axes.axhline(study.own_error(measure), zorder=1.5, **MARKS["reference's own error"])
    axes.plot(*points(front), clip_on=False, zorder=1.8, **MARKS["Pareto set"])
    axes.plot(*points(best), clip_on=False, zorder=1.8, **MARKS["recommended"])
    for name, runs in study.lines.items():
        axes.plot(*points([runs.get(label) for label in study.labels()]), clip_on=False, **shown[name])
    rest = [run for run in there if run not in front] if len(study.lines) <= FEW else []
    write_labels(axes, [(study.label(run), points([run])) for run in front],
                 [(study.label(run), points([run])) for run in rest])
    axes.set(xlabel=COSTS[study.data["cost"]], ylabel=f"relative error of the {ERRORS[measure]}")
    if failed:
        top = figure.add_axes((0, (HEIGHT + 0.05) / height, 1, 1 - (HEIGHT + 0.05) / height), sharex=axes)
        draw_failures(top, failed, shown, study)
    top.set_title(plain(study.data["name"], 80), loc="left", fontsize=10, fontweight="bold")
    needed = {"Pareto set": front, "recommended": best, "tolerance": tolerance,
              "reference's own error": own, "failed": failed}
    entries += [("marks", None)] + [(text, MARKS[text]) for text in MARKS if needed[text]]
    if any(study.error(run, measure) < LEAST for run in there):
        entries.append((f"on the bottom edge: below {LEAST:g}", NOTHING))
    entries += [(f"labels: {study.connect}", NOTHING)] if study.connect else []
    write_legend(axes, entries[:-1] if entries[-1][1] is None else entries)
    return figure


def save(figure, path):
    """Writes path.png and path.svg, the same for the same study; returns the SVG as bytes."""
    for ending in ("png", "svg"):
        target = path.with_name(f"{path.name}.{ending}")
        try:
            figure.savefig(target, bbox_inches="tight", pad_inches=0.06,
                           metadata={"Date": None, "Creator": None} if ending == "svg" else {"Software": None})
        except OSError as error:
            raise ResultsError(f"{target} cannot be written: {error.strerror}") from None
        print(target)
    return target.read_bytes()


def main():
    style.use_style()
    plt.rcParams["svg.hashsalt"] = "study"
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="FOLDER", help="results folder of a study (with study.csv and study.json)")
    study = Study(parser.parse_args().folder)

    pictures = {}
    for measure in study.measures:
        path = study.folder / file_name(measure)
        if any(study.error(run, measure) > 0 for run in study.runs.values()):
            pictures[measure] = save(draw(study, measure), path)
        else:
            for ending in ("png", "svg"):  # of an earlier state of the study
                path.with_name(f"{path.name}.{ending}").unlink(missing_ok=True)
    write_report(study, pictures)


if __name__ == "__main__":
    options.run(main)
