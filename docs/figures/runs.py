"""Helps measure functions: runs programs, reads their results, and compares variants in turns."""
import os
import pathlib
import shlex
import statistics
import sys
import time
from subprocess import DEVNULL, Popen

from .table import ROOT

sys.path[:0] = [str(ROOT / folder) for folder in ("tests/support", "tests/compare", "drivers/plot")]
# pylint: disable=wrong-import-position,unused-import  (tables take measures and results from here)
import forms  # noqa: E402
import measures  # noqa: E402,F401
import results  # noqa: E402,F401
from driver_process import BENCH_ENVIRONMENT, driver_command  # noqa: E402
from result_files import read_history, read_summary  # noqa: E402
from study_results import Study  # noqa: E402

TIME_STEP, FINAL_TIME = forms.STEP, forms.TIME  # paths of parameters
SCHEME = "Time Integrator/Type"
NO_FRAMES = ["Output/Fields Interval=0", "Output/Fields Time Interval=0", "Output/Checkpoint/Keep=0"]


class Failure(Exception):
    """A measurement failed, or lacks what it needs. The message has one line."""


class Done:
    """A program that has ended: its output, its exit status, its wall-clock time and its processor time."""

    def __init__(self, output, status, seconds, cpu_seconds):
        self.output, self.status, self.seconds, self.cpu_seconds = output, status, seconds, cpu_seconds


class Context:
    """What a measure function gets: programs to run, and a folder for their results.

    build: folder of the build. folder: an empty folder. trial: whether a short form is wanted, to see that the function
    works. commands: the command lines so far, as the data file has them.
    """

    def __init__(self, build, folder, trial=False):
        self.build, self.folder, self.trial = pathlib.Path(build).resolve(), pathlib.Path(folder).resolve(), trial
        self.commands = []

    def pick(self, full, short):
        """Returns `short` in a trial, else `full`."""
        return short if self.trial else full

    def program(self, name):
        """Returns the path of ixos, ixos-study or a program of tests/bench. Raises Failure if it is not built."""
        for folder in ("drivers", "tests"):
            if (self.build / folder / name).is_file():
                return self.build / folder / name
        raise Failure(f"{self.build} has no program {name}")

    def execute(self, command, allowed=(0,), variables=None):
        """Runs a command and waits for its end. `variables` are added to its environment. Returns a Done.

        Raises Failure if the exit status is not among `allowed`."""
        words = [str(word) for word in command]
        shown = self._shown(words, variables or {})
        if shown not in self.commands:
            self.commands.append(shown)
        environment = dict(BENCH_ENVIRONMENT, TMPDIR=str(self.folder), **(variables or {}))
        output, errors = self.folder / "stdout", self.folder / "stderr"
        begin = time.perf_counter()
        with open(output, "wb") as out, open(errors, "wb") as err, \
                Popen(words, cwd=ROOT, env=environment, stdin=DEVNULL, stdout=out, stderr=err) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.perf_counter() - begin
        if process.returncode not in allowed:
            last = errors.read_text(encoding="utf-8", errors="replace").strip().splitlines()[-1:]
            raise Failure(f"exit status {process.returncode}: {shown}: {''.join(last)}")
        text = output.read_text(encoding="utf-8", errors="replace")
        return Done(text, process.returncode, seconds, usage.ru_utime + usage.ru_stime)

    def _shown(self, words, variables):
        """Returns a command line as a reader types it: paths below the root, results in the folder `results`."""
        line = shlex.join([*(f"{name}={value}" for name, value in variables.items()), *words])
        for path, name in ((f"{self.folder}", "results"), (f"{self.build}", "build/release"), (f"{ROOT}/", "")):
            line = line.replace(path, name)
        return line

    def run_text(self, program, *arguments, allowed=(0,), variables=None):
        """Runs a program by its name, or a script by its path below the root. Returns what it prints."""
        words = [self.program(program)] if "/" not in program else [ROOT / program]
        if program.endswith(".py"):
            words.insert(0, "/usr/bin/python3")
        return self.execute([*words, *arguments], allowed, variables).output

    def run(self, scene, settings=(), ranks=1, name="run", options=(), allowed=(0,), frames=False, variables=None):
        """Runs a scene with settings LIST/NAME=VALUE. Returns summary.json as a dictionary.

        scene: a name of xml/ or a path below the root. name: folder of the results, below the context's; an earlier run
        of this name is replaced. options: further words of the command line. frames: whether to keep fields and
        checkpoints as the scene says; by default there are none. The dictionary has two more numbers, of the whole
        process: `process_seconds` (wall clock) and `cpu_seconds`."""
        path = ROOT / scene if "/" in scene else ROOT / f"xml/{scene}.xml"
        command = driver_command(str(self.program("ixos")), str(path),
                                 ["--overwrite", "--output", str(self.folder / name), *options],
                                 [*settings, *([] if frames else NO_FRAMES)], ranks)
        done = self.execute(command, allowed, variables)
        return dict(self.summary(name), process_seconds=done.seconds, cpu_seconds=done.cpu_seconds)

    def summary(self, name="run"):
        """Returns summary.json of a run by its name."""
        return read_summary(self.folder / name / "summary.json")

    def history(self, name="run"):
        """Returns the columns of history.csv of a run, by name."""
        return read_history(self.folder / name / "history.csv")

    def study(self, name, short=None):
        """Runs a study of xml/ by its name. Returns it as a Study of drivers/plot/study_results.py.

        short: a ShortStudy of tests/compare/forms.py, with which the study runs. A trial takes the shortest form."""
        short = forms.STUDIES[name] if self.trial else short
        path = forms.write_short_study(name, short, self.folder) if short else ROOT / f"xml/{name}.xml"
        self.execute([self.program("ixos-study"), path, "--output", self.folder / f"{name}.results"])
        return Study(self.folder / f"{name}.results")


class Sample:
    """Numbers of one variant by name: their medians over the repeats, and the medians of their ratios to the base."""

    def __init__(self, rounds, bases):
        self.median, self.ratio = {}, {}
        for name in rounds[0]:
            values = [numbers[name] for numbers in rounds]
            if all(value is not None for value in values):
                self.median[name] = statistics.median(values)
                pairs = [(value, base.get(name)) for value, base in zip(values, bases)]
                if all(base for _, base in pairs):
                    self.ratio[name] = statistics.median(value / base for value, base in pairs)


def interleaved(variants, repeats, measure, warm_up=True):
    """Measures variants in turns, so that another load of the machine meets all of them alike.

    Calls measure(variant), which returns numbers by name, for each variant in each of the repeats; the first variant is
    the base of the ratios. With warm_up, measures the base once more at first, and discards this. Returns a Sample for
    each variant."""
    variants = list(variants)
    if warm_up:
        measure(variants[0])
    rounds = [{variant: measure(variant) for variant in variants} for _ in range(repeats)]
    bases = [numbers[variants[0]] for numbers in rounds]
    return {variant: Sample([numbers[variant] for numbers in rounds], bases) for variant in variants}


def markdown_rows(text):
    """Returns the rows of the first table in Markdown that a program prints, as dictionaries of texts by head."""
    lines = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in text.splitlines()
             if line.startswith("|")]
    return [dict(zip(lines[0], cells)) for cells in lines[2:]]
