"""What the benchmarks of whole runs share: the scenes at a size, a run of some steps, its figures a Newton iteration."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import BENCH_ENVIRONMENT, STEPS  # noqa: E402

SCENES = pathlib.Path(__file__).resolve().parents[2] / "xml"
PHASES = ("residual", "tangent", "factorization", "linear solve")
COLUMNS = ["Newton/increment", "CG/Newton", "s/Newton", *PHASES, "memory, GB"]


def spatula(cells, steps):
    """Scene and settings of the spatula on about so many hexahedra, before it peels."""
    end = 0.5 * steps
    return SCENES / "spatula-stiff.xml", [f"Mesh/Spatula/Target Cells={cells}", f"Histories/Pull/Rate Ramp/Length={end}",
                                    f"{STEPS}Final Time={end}", "Output/Fields Time Interval=0"]


def block(divisions, steps, step=0.5):
    """Scene and settings of the block on the wall with so many unit cubes a direction, steps of `step` T0."""
    text, end = ", ".join(map(str, divisions)), step * steps
    return SCENES / "block-on-wall.xml", [f"Mesh/Box/Divisions={{{text}}}", f"Mesh/Box/Lengths={{{text}}}",
                                          f"Histories/Pull/Rate Ramp/Length={min(end, 2)}",
                                          f"{STEPS}Time Step={step}", f"{STEPS}Final Time={end}"]


def run(build, scene, settings, ranks, variables=()):
    """The summary of a run without checkpoints; `variables` of the environment for its ranks, NAME=value."""
    exported = [word for variable in variables for word in ("-x", variable)]
    with tempfile.TemporaryDirectory() as folder:
        command = ["mpirun", "-np", str(ranks), "--oversubscribe", *exported, f"{build}/drivers/ixos", str(scene), "--quiet",
                   "--output", folder]
        for setting in [*settings, "Output/Checkpoint/Keep=0"]:
            command += ["--set", setting]
        subprocess.run(command, check=True, env=BENCH_ENVIRONMENT)
        with open(f"{folder}/summary.json", encoding="utf-8") as file:
            return json.load(file)


def figures(result):
    """The columns COLUMNS of a summary, as words."""
    newton = result["newton_iterations"]
    return [f'{newton / result["steps"]:.2f}', f'{result["linear_iterations"] / newton:.1f}',
            f'{result["wall_seconds"] / newton:.3f}', *(f'{result["seconds"][phase] / newton:.3f}' for phase in PHASES),
            f'{result["peak_memory_bytes"] / 1e9:.2f}']


def row(*words):
    """Prints a row of a table in Markdown."""
    print("| " + " | ".join(map(str, words)) + " |", flush=True)


def header(*words):
    """Prints the head of one."""
    row(*words)
    print("|" + "---|" * len(words), flush=True)
