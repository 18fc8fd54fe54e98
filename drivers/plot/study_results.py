"""Reads and checks the results of a study: study.csv and study.json."""
import csv
import io
import itertools
import json
import math

from results import ResultsError, existing

COSTS = {"wall_seconds": "wall-clock time [s]", "cpu_seconds": "processor time [s]",
         "newton_iterations": "Newton iterations"}
ERRORS = {**{f"error_{name}": name for name in ("energy", "momentum", "force", "position")},
          "peak_error": "peak force", "work_error": "work"}
VALUES = {"peak": "peak force", "work": "work"}  # what the errors of these compare
COUNTS = ["steps", "rejected_steps", "newton_iterations", "linear_iterations"]
NUMBERS = [*ERRORS, *VALUES, "wall_seconds", "cpu_seconds", *COUNTS, "peak_memory_bytes", "end_time"]
GOOD, FAILED, OPEN = ("completed", "stopped"), ("diverged", "failed"), ("interrupted",)

OPTIONAL = {"connect", "measure", "tolerance", "reference", "recommendation/run"}  # may be null
SHAPE = {
    "name": str, "scene": str, "command": str, "version": str, "axes": [{"name": str, "values": [str]}],
    "connect": str, "cost": str, "measure": str, "tolerance": (int, float),
    "reference": {"description": str, "folder": str, "judgement": str, "own_errors": dict, "notes": [str]},
    "pareto": dict,
    "recommendation": {"run": str, "settings": [str], "sentence": str}, "common": [str],
}


def file_name(measure):
    """The name of a measure's pictures, without their ending."""
    return f"work-precision-{ERRORS[measure].replace(' ', '-')}"


class Study:
    """study.json as `data`; the rows of study.csv by name as `runs`, with NaN for numbers that are not there."""

    def __init__(self, folder):
        self.folder = existing(folder)
        self.data = read_json(self.folder / "study.json")
        self.axes = {axis["name"]: axis["values"] for axis in self.data["axes"]}
        for name, known in (("connect", self.axes), ("cost", COSTS), ("measure", ERRORS)):
            if self.data[name] is not None and self.data[name] not in known:
                raise self.wrong("study.json", f"unknown {name} '{self.data[name]}' (known: {', '.join(known)})")
        tolerance = self.data["tolerance"]
        if tolerance is not None and not 0 < tolerance < math.inf:
            raise self.wrong("study.json", f"the tolerance {tolerance} is not a number greater than 0")
        self.measures = sorted(ERRORS, key=lambda name: name != self.data["measure"])  # the named one first
        self.connect = self.data["connect"] if len(self.axes.get(self.data["connect"], [])) > 1 else None
        self.varying = [name for name, labels in self.axes.items() if len(labels) > 1 and name != self.connect]
        self.runs = self.read_runs()
        best, pareto = self.data["recommendation"]["run"], self.data["pareto"]
        for name in itertools.chain([] if best is None else [best], *pareto.values()):
            if name not in self.runs:
                raise self.wrong("study.json", f"it names the run '{name}', which study.csv does not have")
        self.best = self.runs.get(best)
        self.pareto = {measure: [self.runs[name] for name in pareto.get(measure, [])] for measure in self.measures}
        self.lines = {}  # by the labels of the varying axes: the runs, by the connecting axis' label
        for run in self.runs.values():
            self.lines.setdefault(tuple(run[axis] for axis in self.varying), {})[self.label(run)] = run

    def wrong(self, file, complaint):
        """What to raise."""
        return ResultsError(f"{self.folder / file}: {complaint}")

    def read_runs(self):
        """The rows of study.csv in the order of the axes' labels."""
        path, names, runs = self.folder / "study.csv", set(), {}
        try:
            header, *rows = [row for row in csv.reader(io.StringIO(read(path)), strict=True) if row] or [[]]
        except csv.Error as error:
            raise ResultsError(f"{path}: {error}") from None
        for name in ("run", *self.axes, "status", "reason", *NUMBERS):
            if header.count(name) != 1:
                raise ResultsError(f"{path} has {'two columns' if name in header else 'no column'} '{name}'")
        if not rows:
            raise ResultsError(f"{path} has no rows")
        for cells in rows:
            run = dict(zip(header, cells))
            if len(cells) != len(header):
                raise self.wrong("study.csv", f"run '{cells[0]}' has {len(cells)} cells, the header {len(header)}")
            for column, known in (*self.axes.items(), ("status", GOOD + FAILED + OPEN)):
                if run[column] not in known:
                    raise self.wrong("study.csv", f"run '{run['run']}' has the unknown {column} '{run[column]}'")
            place = tuple(labels.index(run[axis]) for axis, labels in self.axes.items())
            if run["run"] in names or place in runs:
                raise self.wrong("study.csv", f"run '{run['run']}' repeats the name or the settings of an earlier run")
            try:
                run.update((column, float(run[column] or "nan")) for column in NUMBERS)
            except ValueError as error:
                raise self.wrong("study.csv", f"run '{run['run']}': {error}") from None
            names.add(run["run"])
            runs[place] = run
        return {runs[place]["run"]: runs[place] for place in sorted(runs)}

    def own_error(self, measure):
        """Returns the reference's own error; NaN if it is unknown."""
        return (self.data["reference"] or {"own_errors": {}})["own_errors"].get(measure, math.nan)

    def label(self, run):
        """A run's label on the connecting axis, where there is one of several labels."""
        return run[self.connect] if self.connect else ""

    def labels(self):
        """The connecting axis' labels."""
        return self.axes[self.connect] if self.connect else [""]

    def failed(self, line):
        """The runs of a line that failed."""
        return [run for run in self.lines[line].values() if run["status"] in FAILED]

    def cost(self, run):
        """The cost of a run; 0 if it is unknown."""
        cost = run[self.data["cost"]]
        return cost if 0 <= cost < math.inf else 0.0

    @staticmethod
    def error(run, measure):
        """An error of a run that reached its end, else NaN."""
        return run[measure] if run["status"] in GOOD and 0 <= run[measure] < math.inf else math.nan


def read(path):
    """The text of a file."""
    try:
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise ResultsError(f"the file {path} does not exist") from None
    except (OSError, ValueError) as error:
        raise ResultsError(f"{path}: {error}") from None


def read_json(path):
    """study.json, refused where an entry is missing or of another kind."""
    def check(value, shape, place):
        if value is None and place in OPTIONAL:
            return
        if not isinstance(value, type(shape) if isinstance(shape, (dict, list)) else shape):
            raise ResultsError(f"{path}: {f'the entry {place!r}' if place else 'the content'} has the wrong type")
        for name, inner in shape.items() if isinstance(shape, dict) else ():
            below = f"{place}/{name}".strip("/")
            if name not in value:
                raise ResultsError(f"{path} has no entry '{below}'")
            check(value[name], inner, below)
        for inner in value if isinstance(shape, list) else ():
            check(inner, shape[0], place)
    try:
        data = json.loads(read(path))
    except ValueError as error:
        raise ResultsError(f"{path}: {error}") from None
    check(data, SHAPE, "")
    check(list(data["pareto"].values()), [[str]], "pareto")
    for error in (data["reference"] or {"own_errors": {}})["own_errors"].values():
        check(error, (int, float), "reference/own_errors")
    return data
