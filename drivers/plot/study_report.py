"""The report.html of a study, one file that needs no other, and what the report of an advice shares with it."""
import base64
import collections
import html
import math
import re
import shlex

from results import ResultsError
from study_results import COSTS, COUNTS, ERRORS, FAILED, GOOD, OPEN, VALUES, file_name

STYLE = """
:root { color-scheme: light dark; --ink: #222; --soft: #666; --line: #ddd; --back: #fff; --card: #f5f6f8;
  --good: #00704f; --bad: #b3261e; --accent: #0072b2; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e4e4; --soft: #a5a5a5; --line: #3c3c3c; --back: #181818;
  --card: #242424; --good: #5bd1a5; --bad: #ff9088; --accent: #6cbcf0; } }
body { margin: 0 auto; padding: 1.5rem 1.25rem 4rem; max-width: 68rem; background: var(--back); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; margin: 0; overflow-wrap: anywhere; } h2 { font-size: 1.2rem; margin: 2.5rem 0 0.5rem; }
h3 { font-size: 1rem; margin: 1.5rem 0 0.4rem; } p { margin: 0.4rem 0; max-width: 48rem; overflow-wrap: anywhere; }
.soft, figcaption, small { color: var(--soft); } figcaption { font-size: 0.875rem; }
.advice { background: var(--card); border-left: 4px solid var(--accent); padding: 0.8rem 1.1rem; margin: 1.2rem 0; }
.advice h2 { margin: 0; } .advice p { font-size: 1.05rem; } .advice .soft { font-size: 0.875rem; }
pre { background: var(--card); padding: 0.7rem 0.9rem; margin: 0.5rem 0; overflow-x: auto;
  font: 0.85rem/1.45 ui-monospace, monospace; } .advice pre { background: var(--back); }
figure { margin: 1rem 0 2rem; }
figure img { display: block; width: 100%; max-width: 60rem; height: auto; background: #fff;
  padding: 0.6rem; box-sizing: border-box; border: 1px solid var(--line); border-radius: 4px; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: 0.85rem; }
th, td { padding: 0.25rem 0.7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { border-bottom: 2px solid var(--soft); white-space: nowrap; } td { white-space: nowrap; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
td.reason { min-width: 18rem; white-space: normal; }
.good { color: var(--good); } .bad { color: var(--bad); } tr.best td { background: var(--card); font-weight: 600; }
"""


def text(content, kind=""):
    """A cell of text."""
    return f'<td class="{kind}">{html.escape(content)}</td>' if kind else f"<td>{html.escape(content)}</td>"


def number(value, form=".3g"):
    """A cell of a number."""
    return text("–" if math.isnan(value) else format(value, form), "number")


def status(run, more=""):
    """A cell that tells how a run ended, and below it something more."""
    sign, kind = ("✓", "good") if run["status"] in GOOD else ("✗", "bad") if run["status"] in FAILED else ("…", "soft")
    return f'<td class="{kind}">{sign} {html.escape(run["status"])}{more and f"<br><small>{html.escape(more)}</small>"}</td>'


def table(words, numbers, rows):
    """A table: headings of its columns of text and, after those, of numbers; rows: (whether that is the recommended
    run, cells)."""
    head = "".join([f"<th>{html.escape(word)}</th>" for word in words] +
                   [f'<th class="number">{html.escape(word)}</th>' for word in numbers])
    body = "\n".join(f"<tr{best * ' class=best'}>{''.join(cells)}</tr>" for best, cells in rows)
    return f'<div class="scroll" tabindex="0"><table>\n<tr>{head}</tr>\n{body}\n</table></div>'


def paragraph(content, kind=""):
    """A paragraph of text."""
    return f'<p class="{kind}">{html.escape(content)}</p>' if kind else f"<p>{html.escape(content)}</p>"


def command(scene, settings):
    """The command line that runs a scene with settings."""
    quoted = ['"' + re.sub(r'([\\"$`])', r"\\\1", setting) + '"' for setting in settings]
    return " \\\n    ".join([f"ixos {shlex.quote(scene)}"] + [f"--set {setting}" for setting in quoted])


def with_own_error(error, own):
    """An error as text, with the reference's own error if that is known."""
    return f"{error:.3g}" if math.isnan(own) else f"{error:.3g} ± {own:.2g}"


def advice(study):
    """The recommendation: the sentence, and the command that follows it."""
    told, best = study.data["recommendation"], study.best
    parts = ["<h2>Recommendation</h2>", paragraph(told["sentence"])]
    if best:
        parts.append(f"<pre>{html.escape(command(study.data['scene'], told['settings']))}</pre>")
        told = [f"{word.replace(' [s]', '')} {best[name]:.6g}{' s' * word.endswith('[s]')}"
                for name, word in COSTS.items() if not math.isnan(best[name])]
        told += [f"{word} {best[name]:.6g}" for name, word in VALUES.items() if not math.isnan(best[name])]
        told += [f"error of the {word} {with_own_error(best[name], study.own_error(name))}"
                 for name, word in ERRORS.items() if not math.isnan(best[name])]
        parts.append(paragraph(f"Run {best['run']}: {', '.join(told)}.", "soft"))
    return f'<section class="advice">{"".join(parts)}</section>'


def plots(study, pictures):
    """The pictures, as data."""
    parts = ["<h2>Error over cost</h2>"]
    if not pictures:
        return parts + [paragraph("There is no plot: no run that reached its end has a known error greater than 0.")]
    parts.append(paragraph(
        "Runs further left are cheaper, runs further down more accurate. " +
        (f"A line joins the runs that differ only in {study.connect} and breaks where one did not reach its end. "
         if study.connect else "") +
        "Crosses above a plot are runs that failed, at the cost up to the failure. Points on the bottom edge have "
        "errors below 1e-17. Rings mark the Pareto set: no other run is better in both cost and error. Errors near the "
        "reference's own error (dotted) are no better known than that."))
    for measure, svg in pictures.items():
        file = file_name(measure)
        parts.append(f'<figure><img alt="relative error of the {ERRORS[measure]} over {COSTS[study.data["cost"]]}" '
                     f'src="data:image/svg+xml;base64,{base64.b64encode(svg).decode()}">'
                     f"<figcaption>Error of the {ERRORS[measure]} ({file}.png, {file}.svg)</figcaption></figure>")
    return parts


def pareto(study, axes):
    """The Pareto set of each measure."""
    parts = ["<h2>Pareto sets</h2>", paragraph("Runs that no other beats in both cost and error, the cheapest first.")]
    for measure, runs in study.pareto.items():
        if runs:
            parts.append(f"<h3>Error of the {ERRORS[measure]}</h3>")
            parts.append(table(["run", *axes], [COSTS[study.data["cost"]], "relative error", "steps"],
                               [(run is study.best, [text(run["run"]), *(text(run[axis]) for axis in axes),
                                                     number(run[study.data["cost"]], ".4g"), number(run[measure]),
                                                     number(run["steps"], ".0f")]) for run in runs]))
    return parts if len(parts) > 2 else parts[:1] + [paragraph("None: no run that reached its end has a known error.")]


def usability(study):
    """Where each line stops being usable: a row a line, a column a label of the connecting axis."""
    measure, tolerance = study.data["measure"], study.data["tolerance"]
    own = 0 if math.isnan(study.own_error(measure)) else study.own_error(measure)

    def cell(run):
        if run is None:
            return text("– no run")
        error = study.error(run, measure) if measure else math.nan
        more = f"at time {run['end_time']:.4g}" if run["status"] not in GOOD and not math.isnan(run["end_time"]) else ""
        if not math.isnan(error):
            more = f"error {error:.2g}{', within' if tolerance and error + own <= tolerance else ''}"
        return status(run, more)

    told = "Completed runs reached the final time; a criterion of the scene ended stopped runs before it."
    told = f"There is one column per {study.connect}. {told}" if study.connect else told
    told += f" The error is that of the {ERRORS[measure]}" if measure else ""
    if measure:
        told += f"; within: at most the tolerance, {tolerance:g}, with the reference's own error." if tolerance else "."
    return ["<h2>Which runs are usable</h2>", paragraph(told),
            table([*study.varying, *(study.labels() if study.connect else ["status"])], [],
                  [(False, [*map(text, name), *(cell(runs.get(label)) for label in study.labels())])
                   for name, runs in study.lines.items()])]


def all_runs(study, axes):
    """The table of all runs."""
    errors = [name for name in ERRORS if any(not math.isnan(run[name]) for run in study.runs.values())]
    values = [name for name in VALUES if any(not math.isnan(run[name]) for run in study.runs.values())]
    numbers = [*(f"{ERRORS[name]} error" for name in errors), *(VALUES[name] for name in values),
               "wall-clock s", "processor s",
               *(name.replace("_", " ") for name in COUNTS), "memory MB", "end time"]
    rows = [(run is study.best, [
        text(run["run"]), *(text(run[axis]) for axis in axes), status(run), text(run["reason"], "reason"),
        *(number(run[name]) for name in errors), *(number(run[name], ".6g") for name in values),
        number(run["wall_seconds"], ".4g"), number(run["cpu_seconds"], ".4g"),
        *(number(run[name], ".0f") for name in COUNTS), number(run["peak_memory_bytes"] / 1e6, ".0f"),
        number(run["end_time"], ".6g")]) for run in study.runs.values()]
    return ["<h2>All runs</h2>", table(["run", *axes, "status", "reason"], numbers, rows)]


def origin(study):
    """The reference, what all runs share, and how to repeat the study."""
    data = study.data
    shared = [f"{name}: {labels[0]}" for name, labels in study.axes.items() if len(labels) == 1] + data["common"]
    none = {"description": "None.", "folder": "", "judgement": "", "own_errors": {}, "notes": []}
    reference = data["reference"] or none
    own = table(["error of the"], ["reference's own error"],
                [(False, [text(ERRORS[name]), number(error)]) for name, error in reference["own_errors"].items()])
    return ["<h2>Reference</h2>", paragraph(reference["description"]), paragraph(reference["folder"], "soft"),
            paragraph(reference["judgement"]), *([own] if reference["own_errors"] else []),
            *(paragraph(note, "soft") for note in reference["notes"]),
            "<h2>Settings that all runs share</h2>",
            "<pre>" + html.escape("\n".join(shared)) + "</pre>" if shared else paragraph("Only those of the scene."),
            "<h2>To repeat this study</h2>", f"<pre>{html.escape(data['command'])}</pre>",
            paragraph(f"Version {data['version']}. All numbers: study.csv.", "soft")]


def write_page(path, name, parts):
    """Writes a page that needs no other file; parts: HTML below the heading."""
    name = html.escape(name)
    head = ('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>{name}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{name}</h1>\n")
    try:
        path.write_text(head + "\n".join(parts) + "\n</body>\n</html>\n", encoding="utf-8")
    except OSError as error:
        raise ResultsError(f"{path} cannot be written: {error.strerror}") from None
    print(path)


def write_report(study, pictures):
    """Writes report.html; pictures: SVG as bytes by measure."""
    counts = collections.Counter(run["status"] for run in study.runs.values())
    told = ", ".join(f"{counts[name]} {name}" for name in GOOD + FAILED + OPEN if counts[name])
    axes = [name for name, labels in study.axes.items() if len(labels) > 1]
    parts = [paragraph(f"{study.data['scene']} · {len(study.runs)} runs: {told}", "soft"), advice(study),
             *plots(study, pictures), *usability(study), *pareto(study, axes), *all_runs(study, axes), *origin(study)]
    write_page(study.folder / "report.html", study.data["name"], parts)
