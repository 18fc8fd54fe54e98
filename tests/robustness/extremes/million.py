"""A million steps: the energy drift of each scheme, and memory that does not grow."""
import json
import subprocess
import time

import numpy as np

from runs import ENVIRONMENT, EQUILIBRIUM, SCHEMES, Outcome, box, energy_scale, number, scene_text, steps, table, wall
from results import Run

COUNT = 1_000_000


def scene(scheme, count=COUNT, interval=100):
    """Two elements rock in the wall's well, 0.1 of its gap above its bottom at the start: about 45 steps a period."""
    return {**box((4, 2), (2, 1), (0, 1.1 * EQUILIBRIUM)), **wall(), **steps(scheme, 1e-4, count),
            "Initial Conditions/Velocity": [0.01, -2.0], "Initial Conditions/Velocity Gradient": [0.0, -0.5, 0.5, 0.0],
            "Initial Conditions/Origin": [2.0, 1.0], "Output/History Interval": interval}


def resident(pid):
    """Kilobytes of a process that are in memory, or None where it has ended."""
    try:
        with open(f"/proc/{pid}/status") as file:
            return next((int(line.split()[1]) for line in file if line.startswith("VmRSS")), None)
    except OSError:
        return None


def watched(command):
    """Runs a command and samples its memory: exit status, output, list of (seconds, kB)."""
    start, samples = time.time(), []
    with subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        while process.poll() is None:
            memory = resident(process.pid)
            if memory:
                samples.append((time.time() - start, memory))
            time.sleep(1)
        return {"status": process.returncode, "output": process.stdout.read(), "samples": samples,
                "seconds": time.time() - start}


def run_all(runner, count=COUNT):
    """Runs what was not yet run by this driver. All must come to their end."""
    for scheme in SCHEMES:
        folder = runner.folder / "million" / scheme
        text = scene_text(scene(scheme, count))
        kept = folder / "memory.json"
        record = json.loads(kept.read_text()) if kept.is_file() else {}
        if record.get("key") != runner.key(text):
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "scene.xml").write_text(text)
            record = watched([runner.driver, str(folder / "scene.xml"), "--quiet", "--overwrite", "--output",
                              str(folder / "out")])
            record["key"] = runner.key(text)
            kept.write_text(json.dumps(record))
        outcome = runner.judged(f"million/{scheme}", Outcome(folder / "out", record))
        if outcome.kind in ("failed", "refused"):
            runner.defects.append(f"million/{scheme}: {outcome.kind}: {outcome.message}")


def row(scheme, run, record):
    """A row of the table: energy errors over the depth of the well, change of the momentum along the wall over the
    largest upright, memory (before the checkpoint of the end, which takes 2 to 3 MB once)."""
    error = run.energy_error() / energy_scale(run)
    tenth = len(error) // 10
    x = run["linear_momentum_x"]
    memory = dict.fromkeys(("5 %", "50 %", "98 %"))
    for name, share in zip(memory, (0.05, 0.5, 0.98)):
        before = [kb for seconds, kb in record["samples"] if seconds <= share * record["seconds"]]
        memory[name] = before[-1] if before else None
    return [scheme, run.summary["status"], f'{run.summary["steps"]:,}', number(error[:tenth].max()), number(error.max()),
            number(error[-tenth:].mean()), number(np.abs(x - x[0]).max() / np.abs(run["linear_momentum_y"]).max()),
            *(f"{kb / 1024:.1f}" if kb else "-" for kb in memory.values())]


def picture(runs, path):
    """Energy error over the steps."""
    import style
    style.use_style()
    figure, axes = style.plt.subplots(figsize=(6.4, 3.2))
    for scheme, run in runs:
        error = np.maximum.accumulate(run.energy_error() / energy_scale(run))
        axes.loglog(np.maximum(run["step"][1:], 1), np.maximum(error[1:], 1e-17), label=scheme)
    axes.set_xlabel("steps")
    axes.set_ylabel("largest energy error so far / depth of the well")
    style.legend(figure, *axes.get_legend_handles_labels())
    style.save(figure, str(path), ["png"])
    style.plt.close(figure)


def study(runner, images):
    run_all(runner)
    rows, runs = [], []
    for scheme in SCHEMES:
        folder = runner.folder / "million" / scheme
        record, run = json.loads((folder / "memory.json").read_text()), Run(folder / "out")
        rows.append(row(scheme, run, record))
        runs.append((scheme, run))
    picture(runs, images / "extremes-million")
    return table(["scheme", "ended", "steps", "energy error, first tenth", "in all", "mean of the last tenth",
                  "momentum along the wall", "MB at 5 %", "at 50 %", "at 98 %"], rows)
