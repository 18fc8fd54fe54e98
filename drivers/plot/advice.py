#!/usr/bin/python3
"""Draws the error over the cost of the runs of an advice, and writes report.html, a single file that needs no other."""
import base64
import html
import json
import math
import pathlib

import options
import style
from results import ResultsError
from style import plt
from study import HEIGHT, MARKS, WIDTH, limits, plain, save, set_scale, write_legend
from study_report import command, number, paragraph, table, text, write_page

EPILOG = """Examples:
  advice.py strip-advice.results     -> strip-advice.results/advice.png, .svg; strip-advice.results/report.html

The script reads advice.json, which ixos-study --advise writes. A point is a run with its expected error; a run whose
error the other runs do not tell has none. Rings mark the settings that no others beat in both cost and error; those
that were not run are rings without a point."""

RUNS = {"marker": "o", "markersize": 4.5, "linestyle": "none", "color": style.COLORS[0]}


def read(folder):
    """Returns advice.json of a folder."""
    path = folder / "advice.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ResultsError(f"the file {path} does not exist") from None
    except (OSError, ValueError) as error:
        raise ResultsError(f"{path}: {error}") from None


def percent(part):
    """A part as text in per cent; a dash if it is unknown."""
    return "–" if part is None or not math.isfinite(part) else f"{100 * part:.2g} %"


def draw(advice):
    """Returns the figure, or None if no error is known."""
    runs = [run for run in advice["runs"] if run["error"] and run["seconds"] > 0]
    best = [each for each in advice["pareto"] if each["error"] > 0 and each["seconds"] > 0]
    if not runs and not best:
        return None
    figure = plt.figure(figsize=(WIDTH, HEIGHT))
    axes = figure.add_axes((0, 0, 1, 1))
    set_scale(axes.xaxis, *limits([each["seconds"] for each in runs + best], 0.07))
    set_scale(axes.yaxis, *limits([each["error"] for each in runs + best] + [advice["tolerance"]], 0.07))
    axes.axhline(advice["tolerance"], zorder=1.5, **MARKS["tolerance"])
    shown = [("tolerance", MARKS["tolerance"])]
    for name, look, points in (("Pareto set", MARKS["Pareto set"], best), ("runs", RUNS, runs),
                               ("recommended", MARKS["recommended"], [advice["recommended"]])):
        points = [point for point in points if point]
        if points:
            axes.plot([point["seconds"] for point in points], [point["error"] for point in points], clip_on=False, **look)
            shown.append((name, look))
    axes.set(xlabel="processor time [s]", ylabel="expected relative error, at most")
    axes.set_title(plain(title(advice), 80), loc="left", fontsize=10, fontweight="bold")
    write_legend(axes, shown)
    return figure


def title(advice):
    """The name of the page."""
    return f"Advice: {pathlib.Path(advice['scene']).stem}"


def unexamined(advice):
    """The names of what the runs did not examine for some quantity, in the order of the answer."""
    return list(dict.fromkeys(name for each in advice["quantities"] for name in each.get("not_examined", [])))


def answer(advice):
    """The recommendation, or why there is none."""
    rest = f" without what was not examined: {', '.join(unexamined(advice))}" if unexamined(advice) else ""
    best, known, plane = advice["recommended"], advice["most_accurate"], advice.get("plane")
    parts = ["<h2>Recommendation</h2>"]
    if plane:
        parts.append(paragraph(f"Two dimensions will do; on the coarsest mesh they change the quantities by "
                               f"{percent(plane['difference'])}. Settings and numbers are for a depth of 1 L0, where "
                               f"the scene has {plane['depth']:g} L0; z is called y."))
    if best:
        parts.append(paragraph(f"Within the tolerance {percent(advice['tolerance'])}: {best['description']}. The error is "
                               f"at most {percent(best['error'])}{rest}; a run takes {best['seconds']:.2g} s."))
        if advice.get("fails_later"):
            parts.append(paragraph("That run fails after the times that decide the quantities: "
                                   f"{advice['fails_later']}."))
        parts.append(f"<pre>{html.escape(command((plane or advice)['scene'], best['settings']))}</pre>")
    elif known:
        parts.append(paragraph(f"No settings were found within the tolerance {percent(advice['tolerance'])}. The smallest "
                               f"error seen is {percent(known['error'])}{rest}: {known['description']}."))
    if advice["problem"]:
        parts.append(paragraph(advice["problem"]))
    if advice.get("verification"):
        parts.append(paragraph(advice["verification"]))
    return f'<section class="advice">{"".join(parts)}</section>'


def quantities(advice):
    """The errors of each quantity and their parts."""
    rows = []
    for each in advice["quantities"]:
        for name, part in each.get("parts", {}).items():
            known = percent(part["error"]) if part.get("examined", True) else "not examined"
            rows.append((False, [text(each["name"]), text(name), text(part["reason"], "reason"),
                                 text(known, "number")]))
        if "error" in each:
            whole = "all that was examined" if each.get("not_examined") else "all"
            rows.append((True, [text(each["name"]), text(whole), text(f"estimated value {each['estimate']:.6g}", "reason"),
                                text(percent(each["error"]), "number")]))
    return ["<h2>Errors to expect</h2>", table(["quantity", "of", "how it is known"], ["error, at most"], rows)]


def choices(advice):
    """The errors and times of other choices."""
    rows = [(False, [text(each["choice"]), *(text(percent(error), "number") for error in each["errors"]),
                     number(each["seconds"])]) for each in advice["choices"]]
    names = [f"error of {each['name']}" for each in advice["quantities"]]
    return ["<h2>Other choices</h2>", paragraph("Each alone, in place of the recommended one; the last column is the time "
                                                "that the recommended run would take with it."),
            table(["choice"], [*names, "processor s"], rows)] if rows else []


def tolerances(advice):
    """The settings for other tolerances."""
    rows = []
    for each in advice["other_tolerances"]:
        found = each["settings"]
        words = found["description"] + found["extrapolated"] * " (extrapolated)" if found else "no settings known"
        rows.append((False, [text(percent(each["tolerance"])), text(words, "reason"),
                             number(found["seconds"] if found else math.nan)]))
    return ["<h2>Other tolerances</h2>", table(["tolerance", "settings"], ["processor s"], rows)]


def runs(advice):
    """The table of all runs."""
    best = advice["recommended"]["description"] if advice["recommended"] else None
    names = [each["name"] for each in advice["quantities"]]
    rows = []
    for run in advice["runs"]:
        values = run["values"] or [math.nan] * len(names)
        rows.append((run["description"] == best, [
            text(run["description"]), text("" if run["good"] else run["reason"], "reason"),
            *(number(value, ".6g") for value in values), text(percent(run["error"]), "number"), number(run["seconds"])]))
    return ["<h2>All runs</h2>", table(["run", "reason"], [*names, "error, at most", "processor s"], rows)]


def write_report(advice, folder, picture):
    """Writes report.html."""
    parts = [paragraph(f"{advice['scene']} · {len(advice['runs'])} runs of {advice['spent_seconds']:.3g} s together, "
                       f"of a budget of {advice['budget_seconds']:.3g} s", "soft"), answer(advice), *quantities(advice)]
    if picture:
        parts += ["<h2>Error over cost</h2>",
                  f'<figure><img alt="expected error over processor time" src="data:image/svg+xml;base64,'
                  f'{base64.b64encode(picture).decode()}"><figcaption>A point is a run. Rings mark settings that no others '
                  "beat in both cost and error; some may not have been run.</figcaption></figure>"]
    parts += [*choices(advice), *tolerances(advice), *runs(advice), "<h2>To repeat this advice</h2>",
              f"<pre>{html.escape(advice['command'])}</pre>",
              paragraph(f"Version {advice['version']}. All numbers: advice.json.", "soft")]
    write_page(folder / "report.html", title(advice), parts)


def main():
    style.use_style()
    plt.rcParams["svg.hashsalt"] = "advice"
    parser = options.Parser(__doc__, EPILOG)
    parser.add_argument("folder", metavar="FOLDER", help="results folder of an advice (with advice.json)")
    folder = pathlib.Path(parser.parse_args().folder)
    advice = read(folder)
    figure = draw(advice)
    write_report(advice, folder, save(figure, folder / "advice") if figure else None)


if __name__ == "__main__":
    options.run(main)
