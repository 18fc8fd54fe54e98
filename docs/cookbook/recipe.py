"""What the studies of the cookbook share: runs of a scene, the reference's numbers, tables and pictures.

A study, docs/cookbook/NAME/study.py, runs xml/NAME.xml over the values of its page. It needs NumPy, SciPy and
Matplotlib, and the driver: the environment variable IXOS_DRIVER, or build/release/drivers/ixos."""
import argparse
import csv
import importlib.util
import os
import pathlib
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "drivers/plot"), str(ROOT / "tests/support")]
from driver_process import ENVIRONMENT, STEPS, driver_command  # noqa: E402 (studies set the step control by STEPS)
import results  # noqa: E402
import style  # noqa: E402

DRIVER = os.environ.get("IXOS_DRIVER", str(ROOT / "build/release/drivers/ixos"))

# The default law of the wall, Van der Waals: work of adhesion [E0 L0], equilibrium gap [L0], largest attraction [E0].
WORK = 15 ** (1 / 3) * 3.141592653589793 / 500
EQUILIBRIUM_GAP = 15 ** (-1 / 6) / 2.5
STRENGTH = 0.0624428

# Settings of runs of which the history is all that counts, and of the half of a section in plane strain, of a scene
# whose symmetry is "Middle".
QUIET = {"Output/Fields Time Interval": 0, "Output/Checkpoint/Keep": 0}
HALF_SECTION = {"Mesh/Geometry": "Plane Strain", "Boundary Conditions/Middle/Node Set": "left",
                "Boundary Conditions/Middle/Components": "x"}


def law(gap):
    """Returns energy, traction and the traction's derivative of the default law at a gap; repulsion is positive."""
    q, scale = EQUILIBRIUM_GAP / gap, 8 * WORK / (3 * EQUILIBRIUM_GAP)
    return WORK / 3 * (q ** 8 - 4 * q ** 2), scale * (q ** 9 - q ** 3), scale / gap * (3 * q ** 3 - 9 * q ** 9)


def run(scene, settings, folder, restart=None):
    """Runs a scene of xml/ in the driver. Returns its results as a results.Run.

    scene: the file's name without ".xml"; settings: values by their list paths, as of --set; folder: of the results,
    replaced if it exists; restart: folder of a run to resume, if any. Throws RuntimeError, with the driver's message, if the run does not complete."""
    assignments = [f"{path}={text(value)}" for path, value in settings.items()]
    arguments = ["--output", str(folder), "--overwrite"] + (["--restart", str(restart)] if restart else [])
    command = driver_command(DRIVER, str(ROOT / "xml" / (scene + ".xml")), arguments, assignments, 1)
    done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{scene}, {'; '.join(assignments)}: {done.stderr.strip() or done.stdout.strip()}")
    return results.Run(folder)


def text(value):
    """Returns a setting as the driver reads it: all digits of a number, braces around a list."""
    if isinstance(value, (list, tuple)):
        return "{" + ", ".join(text(entry) for entry in value) + "}"
    return repr(float(value)) if isinstance(value, float) else str(value)


def reference(name, file="reference.csv"):
    """Returns the rows of a table in docs/cookbook/NAME as dictionaries; what reads as a number is one."""
    def cell(value):
        try:
            return float(value)
        except ValueError:
            return value
    with open(ROOT / "docs/cookbook" / name / file, newline="", encoding="utf-8") as lines:
        return [{key: cell(value) for key, value in row.items()} for row in csv.DictReader(lines)]


def study(name):
    """Returns docs/cookbook/NAME/study.py as a module: drivers/plot has a module of the name study, too."""
    specification = importlib.util.spec_from_file_location(name + "_study", ROOT / "docs/cookbook" / name / "study.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def vertex(x, y, i):
    """Returns the place and the value of the extreme of the parabola through y[i] and its neighbours."""
    a, b, c = np.polyfit(x[i - 1:i + 2] - x[i], y[i - 1:i + 2], 2)
    return x[i] - b / (2 * a), c - b * b / (4 * a)


def deviation(measured, expected):
    """Returns measured/expected - 1 in per cent as text."""
    return f"{100 * (measured / expected - 1):+.2f} %"


def table(head, rows):
    """Prints a Markdown table."""
    for cells in (head, ["---"] * len(head), *rows):
        print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def arguments(document):
    """Reads the command line of a study: the folder of its results."""
    parser = argparse.ArgumentParser(description=document, formatter_class=argparse.RawDescriptionHelpFormatter)
    name = pathlib.Path(sys.argv[0]).resolve().parent.name
    parser.add_argument("--results", type=pathlib.Path, default=pathlib.Path("results/cookbook", name),
                        help="folder of the results of all runs (default: %(default)s)")
    return parser.parse_args()


def figure(columns=1, width=6.4, height=3.0):
    """Returns a Matplotlib figure in the style of all pictures, and its axes side by side."""
    style.use_style()
    return style.plt.subplots(1, columns, figsize=(width, height), layout="constrained")


def save(picture, name):
    """Writes a figure to docs/cookbook/NAME/NAME.png."""
    path = ROOT / "docs/cookbook" / name / (name + ".png")
    picture.savefig(path, dpi=130)
    style.plt.close(picture)
    print(f"\nwrote {path.relative_to(ROOT)}")
