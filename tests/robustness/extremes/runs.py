"""Small scenes as dictionaries, the driver run on them, and what came of it."""
import hashlib
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "drivers/plot"), str(ROOT / "tests/support")]

from driver_process import ENVIRONMENT, STEPS  # noqa: E402 (after the path)
from results import Run  # noqa: E402

SCHEMES = ["Newmark", "Generalized-Alpha", "HHT-Alpha", "Bathe Composite", "Gautam-Sauer Composite", "Midpoint",
           "Average Vector Field", "Energy-Momentum", "Central Difference"]
R0 = 0.4  # 1/Gamma L of the default interaction
EQUILIBRIUM = 15 ** (-1 / 6) * R0


def box(lengths, divisions, lower=None):
    """The entries of a block of elements."""
    entries = {"Mesh/Type": "Box", "Mesh/Box/Dimension": len(lengths), "Mesh/Box/Lengths": [float(x) for x in lengths],
               "Mesh/Box/Divisions": list(divisions), "Materials/Body/Block": "body"}
    if lower:
        entries["Mesh/Box/Lower"] = [float(x) for x in lower]
    return entries


# Elements to compare: a formulation, or quadratic cells.
ELEMENTS = ["Standard", "Mean Dilatation", "Enhanced", "Quadratic"]


def element(name):
    """The entries that choose one of ELEMENTS for the body."""
    return {"Mesh/Cell Order": 2} if name == "Quadratic" else {"Materials/Body/Element Formulation": name}


def steps(scheme, step, count, initial=0.0):
    """The entries of `count` steps."""
    return {"Time Integrator/Type": scheme, STEPS + "Time Step": step, STEPS + "Initial Time": initial,
            STEPS + "Final Time": initial + step * count}


def wall(side_set="bottom", **entries):
    """The entries of an interaction with the wall through the origin; `Gamma_L=1.0` names "Gamma L"."""
    return {"Interactions/Wall/Side Set": side_set,
            **{"Interactions/Wall/" + name.replace("_", " "): value for name, value in entries.items()}}


def held(name, node_set, components, history=""):
    """The entries of a prescribed displacement."""
    path = f"Boundary Conditions/{name}/"
    return {path + "Node Set": node_set, path + "Components": components, **({path + "History": history} if history else {})}


def ramp(name, rate):
    """The entries of a motion or load that grows from time 0."""
    path, rate = f"Histories/{name}/", float(rate)
    return {path + "Type": "Expression", path + "Expression/Value": f"{rate!r}*t", path + "Expression/Velocity": repr(rate),
            path + "Expression/Acceleration": "0"}


def scene_text(entries):
    """A scene in XML from a dictionary of list paths."""
    tree = {}
    for path, value in entries.items():
        *lists, name = path.split("/")
        node = tree
        for word in lists:
            node = node.setdefault(word, {})
        node[name] = value

    def write(node, depth):
        lines = []
        for name, value in node.items():
            if isinstance(value, dict):
                lines += ["  " * depth + f'<ParameterList name="{name}">', *write(value, depth + 1),
                          "  " * depth + "</ParameterList>"]
                continue
            kinds = {bool: "bool", int: "int", float: "double", str: "string"}
            kind = f"Array({kinds[type(value[0])]})" if isinstance(value, list) else kinds[type(value)]
            text = "{" + ", ".join(map(str, value)) + "}" if isinstance(value, list) else str(value).replace("True", "true")
            lines.append("  " * depth + f'<Parameter name="{name}" type="{kind}" value="{text}"/>')
        return lines

    return "\n".join(['<ParameterList name="Extreme">', *write(tree, 1), "</ParameterList>", ""])


class Outcome:
    """How a run ended. `kind`: completed, failed (status 3), refused (2), or what must not be: defect, crash, hang, NaN."""

    def __init__(self, folder, record):
        self.folder, self.status, self.output, self.seconds = folder, record["status"], record["output"], record["seconds"]
        self.kind = {0: "completed", 1: "defect", 2: "refused", 3: "failed", -1: "hang"}.get(self.status, "crash")
        if self.kind in ("completed", "failed") and self.has_nan():
            self.kind = "NaN"

    @property
    def message(self):
        """The message that the driver prints, without folders: why the run ended, or else all warnings."""
        lines = [line[6:] for line in self.output.splitlines() if line.startswith("ixos: ")]
        if self.status == 0:
            return "; ".join(lines)
        reasons = [line for line in lines if not line.startswith("warning: ")] or lines or self.output.strip().splitlines()[-1:]
        text = reasons[0] if reasons else ""
        return re.sub(r"\. Results up to there are in .*", "", re.sub(r"^\S*scene\.xml: ", "", text))

    @property
    def run(self):
        return Run(self.folder)

    def has_nan(self):
        file = self.folder / "history.csv"
        return file.is_file() and "nan" in file.read_text()

    def energy_error(self):
        """Largest energy error over the largest kinetic, elastic or interaction energy of the run: 1 is wrong altogether."""
        run = self.run
        return float(run.energy_error().max() / energy_scale(run))


def energy_scale(run):
    """The largest kinetic, elastic or interaction energy of a run."""
    names = ("kinetic_energy", "elastic_energy", "contact_energy")
    return max(*(np.abs(run[name]).max() for name in names if run.has(name)), 1e-300)


class Runner:
    """Runs scenes in folders below `folder`; a run that was made with this driver before is not repeated."""

    def __init__(self, folder, driver):
        self.folder, self.driver, self.defects = pathlib.Path(folder).resolve(), str(driver), []
        libraries = [pathlib.Path(driver).resolve().parents[1] / "lib" / name for name in ("libixos.so", "libixos_solvers.so")]
        self.version = [file.stat().st_mtime for file in [pathlib.Path(driver), *libraries] if file.exists()]

    def __call__(self, name, entries, ranks=1, timeout=120):
        folder = self.folder / name
        text = scene_text(entries)
        key = self.key(text, ranks)
        kept = folder / "outcome.json"
        if kept.is_file() and json.loads(kept.read_text())["key"] == key:
            return self.judged(name, Outcome(folder / "out", json.loads(kept.read_text())))
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder / "scene.xml").write_text(text)
        launcher = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
        command = [*launcher, self.driver, str(folder / "scene.xml"), "--output", str(folder / "out")]
        record = {"key": key, **self.execute(command, timeout)}
        kept.write_text(json.dumps(record))
        return self.judged(name, Outcome(folder / "out", record))

    def key(self, text, ranks=1):
        """Tells a run by its scene, its ranks and the driver."""
        return hashlib.sha256(json.dumps([text, ranks, self.version]).encode()).hexdigest()

    def judged(self, name, outcome):
        """Remembers what must not be."""
        if outcome.kind not in ("completed", "failed", "refused"):
            self.defects.append(f"{name}: {outcome.kind}: {outcome.message}")
        return outcome

    def execute(self, command, timeout):
        start = time.time()
        try:
            done = subprocess.run(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  timeout=timeout, check=False)
            return {"status": done.returncode if done.returncode >= 0 else 128 - done.returncode, "output": done.stdout,
                    "seconds": time.time() - start}
        except subprocess.TimeoutExpired as expired:
            output = expired.stdout or b""
            return {"status": -1, "output": output.decode() if isinstance(output, bytes) else output,
                    "seconds": time.time() - start}


def table(head, rows):
    """A table in Markdown."""
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(map(str, row)) + " |" for row in rows)]


def number(value, digits=2):
    """A number for a table."""
    if value is None or not math.isfinite(value):
        return "-" if value is None else str(value)
    return f"{value:.{digits}g}"
