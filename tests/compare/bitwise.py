#!/usr/bin/env python3
"""Compares the results of two builds of Ixos bit for bit, and times the builds side by side.

    tests/compare/bitwise.py --before BUILD_OR_COMMIT [--after build/release] [--only NAME] [--tolerance 1e-12]
        [--times [only]] [--keep FOLDER]

Both builds run the scenes and studies of this source tree in short forms (forms.py). The script compares history.csv,
and study.csv of studies, but for the columns of clocks and memory. It prints a table in Markdown: scene, number of
rows, result. Row 0 is the first row below the header. A difference is relative to the largest magnitude of its column,
so it is large in a column that holds rounding errors only, such as a momentum across the motion. The exit status is 1
if a form fails, differs beyond the tolerance, or lacks a column that it had before.

--times runs some scenes with both builds in turns, ten times each, and the benchmark product_times if both builds have
it (target `benchmarks`). It prints the least times and their ratio, and the least and the largest ratio of a pair of
runs, one of each build. The machine should be idle.
"""
import argparse
import contextlib
import functools
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from forms import forms_to_compare, forms_to_time
from tables import Comparison
from driver_process import BENCH_ENVIRONMENT, ROOT, driver_command, test_environment  # forms.py adds its folder

ENVIRONMENT = {**BENCH_ENVIRONMENT, **test_environment()}
NAMES = ("before", "after")
PAIRS = 10        # of runs, for a ratio of times
TIME_LIMIT = 900  # seconds that a run may take


def call(build, command, folder):
    """Runs a command with the library of a build. Returns its exit status and its output."""
    path = ":".join(filter(None, [str(build / "lib"), ENVIRONMENT.get("LD_LIBRARY_PATH")]))
    try:
        process = subprocess.run(command, cwd=folder, env=dict(ENVIRONMENT, LD_LIBRARY_PATH=path), text=True,
                                 check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return None, f"the run did not end within {TIME_LIMIT} s"
    return process.returncode, process.stdout.strip()


def run(build, form, folder):
    """Runs a form in a new folder. Returns its exit status, its output and the folder of its results."""
    folder.mkdir(parents=True)
    status, output = call(build, driver_command(str(build / "drivers" / form.program), str(form.file),
                                                ["--output", "results"], form.settings, form.ranks), folder)
    if status == 4 and (folder / "results/report.log").exists():
        status = 0  # the study is complete, only its plots are missing
    return status, output, folder / "results"


def compare(builds, folder, tolerance, form):
    """Runs a form with both builds. Returns the number of rows, the result in words, and whether it passes."""
    ends = [run(build, form, folder / form.name / name) for name, build in zip(NAMES, builds)]
    statuses = [status for status, _, _ in ends]
    if statuses[0] != statuses[1] or statuses[0] not in (0, 3):
        said = [f"{name}: exit status {status}" + (f", {output.splitlines()[-1]}" if output else "")
                for name, (status, output, _) in zip(NAMES, ends)]
        return 0, "FAILED, " + "; ".join(said), False
    tables = [{str(path.relative_to(results)): path for pattern in ("history.csv", "study.csv", "runs/*/history.csv")
               for path in sorted(results.glob(pattern))} for _, _, results in ends]
    comparison = Comparison()
    for table in {**tables[0], **tables[1]}:
        if table in tables[0] and table in tables[1]:
            comparison.add(f"{table}, " if len(tables[0]) > 1 else "", tables[0][table], tables[1][table])
        else:
            comparison.problems.append(f"there is no {table} {NAMES[table in tables[0]]}")
    if comparison.rows == 0:
        comparison.problems.append("there is nothing to compare")
    text, passed = comparison.judge(tolerance)
    return comparison.rows, text + ("; both end with exit status 3" if statuses[0] == 3 else ""), passed


def measure_run(form, folder, build):
    """Returns the seconds of a run's time loop and its number of Newton iterations, by the form's name."""
    status, output, results = run(build, form, folder / "timed")
    if status != 0:
        sys.exit(f"{form.name} with {build}: exit status {status}\n{output}")
    summary = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    shutil.rmtree(folder / "timed")
    return {form.name: (summary["wall_seconds"], summary["newton_iterations"])}


def measure_product(folder, build):
    """Returns the median seconds of each way to multiply a tangent by a vector, from the benchmark product_times."""
    status, output = call(build, [str(build / "tests/product_times"), "32", "40"], folder)
    if status != 0:
        sys.exit(f"product_times of {build}: exit status {status}\n{output}")
    rows = [[cell.strip() for cell in line.split("|")] for line in output.splitlines() if line.startswith("| ")]
    return {f"product, {row[1]}": (1e-3 * float(row[3]), "") for row in rows[1:]}


def print_times(builds, measure):
    """Measures both builds in turns and prints a row for each name. The build that begins changes from pair to pair."""
    samples = ([], [])
    for pair in range(PAIRS):
        for which in (0, 1) if pair % 2 == 0 else (1, 0):
            samples[which].append(measure(builds[which]))
    for name in samples[0][0]:
        before, after = ([sample[name][0] for sample in side] for side in samples)
        ratios = [b / a for a, b in zip(before, after)]
        first, second = min(before), min(after)
        print(f"| {name} | {first:.4g} | {second:.4g} | {second / first:.3f} | {min(ratios):.3f} to "
              f"{max(ratios):.3f} | {samples[0][0][name][1]} | {samples[1][0][name][1]} |", flush=True)


def compare_and_time(options, builds, folder):
    """Prints the tables that the options ask for. Returns whether every form passes."""
    listed = [call(build, [str(build / "drivers/ixos"), "--list-schemes"], folder)[1].splitlines() for build in builds]
    schemes = [[line for line in lines if line and not line.startswith(" ")] for lines in listed]
    chosen = [form for form in forms_to_compare(schemes[0], folder) if options.only in form.name]
    chosen = [] if options.times == "only" else chosen
    measures = [functools.partial(measure_run, form, folder) for form in forms_to_time() if options.only in form.name]
    if options.only in "product" and all((build / "tests/product_times").exists() for build in builds):
        measures.append(functools.partial(measure_product, folder))
    measures = measures if options.times else []
    if not chosen and not measures:
        sys.exit(f"no form has \"{options.only}\" in its name")
    all_passed = True
    if chosen:
        print("| scene | rows | result |\n|---|---|---|", flush=True)
    for form in chosen:
        rows, text, passed = compare(builds, folder, options.tolerance, form)
        all_passed = all_passed and passed
        print(f"| {form.name} | {rows} | {text.replace('|', '/')} |", flush=True)
    new = [scheme for scheme in schemes[1] if scheme not in schemes[0]]
    if chosen and new:
        print(f"\nNew schemes, not compared: {', '.join(new)}")
    if measures:
        print("\n| run | before, s | after, s | after/before | least to largest | Newton iterations before | after |")
        print("|---" * 7 + "|", flush=True)
    for measure in measures:
        print_times(builds, measure)
    return all_passed


@contextlib.contextmanager
def commit_built(commit, source, keep):
    """Builds a commit in a git worktree, gives the folder of the build, and then removes the worktree unless kept."""
    worktree = ["git", "-C", ROOT, "worktree"]
    try:
        targets = ["--target", "ixos_driver", "ixos_study"]
        for command, place in (([*worktree, "add", "--detach", str(source), commit], ROOT),
                               (["cmake", "--preset", "release"], source),
                               (["cmake", "--build", "build/release", *targets], source)):
            if subprocess.run(command, cwd=place, stdout=sys.stderr, check=False).returncode != 0:
                sys.exit(f"--before {commit}: this command failed: {' '.join(command)}")
        yield source / "build/release"
    finally:
        if not keep and source.exists():
            subprocess.run([*worktree, "remove", "--force", str(source)], check=False)


def is_build(folder):
    """Returns whether a folder has the driver and the library that the driver loads."""
    return (folder / "drivers/ixos").exists() and (folder / "lib/libixos.so").exists()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--before", required=True, metavar="BUILD_OR_COMMIT",
                        help="folder of a build, or a git commit, which the script builds in a temporary folder")
    parser.add_argument("--after", type=pathlib.Path, default=pathlib.Path(ROOT, "build/release"), metavar="BUILD",
                        help="folder of a build (default: build/release); the script does not build it")
    parser.add_argument("--only", default="", metavar="NAME", help="take the forms that have NAME in their name")
    parser.add_argument("--tolerance", type=float, default=0, metavar="X", help="largest relative difference allowed")
    parser.add_argument("--times", nargs="?", const=True, choices=["only"], metavar="only",
                        help="time the builds too, or only time them")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER",
                        help="put the results and the worktree into this new folder, and keep them")
    options = parser.parse_args()
    before = pathlib.Path(options.before).resolve()
    commit = ["git", "-C", ROOT, "rev-parse", "--verify", "--quiet", "--end-of-options", options.before + "^{commit}"]
    if not is_build(options.after):
        parser.error(f"--after {options.after}: this folder lacks drivers/ixos or lib/libixos.so")
    if not is_build(before) and subprocess.run(commit, stdout=subprocess.DEVNULL, check=False).returncode != 0:
        parser.error(f"--before {options.before}: neither a commit nor a folder with drivers/ixos and lib/libixos.so")
    if options.keep and options.keep.exists():
        parser.error(f"--keep {options.keep}: this exists; name a new folder")
    with contextlib.ExitStack() as stack:
        temporary = options.keep or stack.enter_context(tempfile.TemporaryDirectory())
        folder = pathlib.Path(temporary).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        if not is_build(before):
            before = stack.enter_context(commit_built(options.before, folder / "source", options.keep))
        return 0 if compare_and_time(options, (before, options.after.resolve()), folder) else 1


if __name__ == "__main__":
    sys.exit(main())
