#!/usr/bin/python3
"""Times increments of two balls that touch, and of one ball of as many cells before a wall, one after the other.

    tests/bench/pair_times.py [--driver build/release/drivers/ixos] [--cells 16,10] [--steps 6] [--ranks 1] [--messages]

The balls have --cells core divisions and rings; the one ball has about twice as many cells. All begin at rest, a gap
1.2 times that of equilibrium apart. The table has the processor time, the Newton iterations and the phases of an
increment after the first one, and the ratio of two balls to one, for an increment and for a Newton iteration. Each
number is the least of --repeats runs, in turns. With --messages the table has what a rank sends in a Newton iteration
instead, the mean over the ranks and the most, counted by the library message_counter. --write FILE writes the scene of
two balls and runs nothing, for a profiler."""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "robustness/extremes"))
from runs import ENVIRONMENT, EQUILIBRIUM, ROOT, scene_text, steps, table  # noqa: E402

DIAMETER = 20.0
PHASES = "residual", "tangent", "linear solve"


def shape(divisions, rings, height):
    return {"Type": "Ball", "Ball/Diameter": DIAMETER, "Ball/Center": [0.0, 0.0, height],
            "Ball/Core Divisions": divisions, "Ball/Rings": rings}


def material(block):
    return {f"Materials/{block}/Block": block, f"Materials/{block}/Poisson's Ratio": 0.2,
            f"Materials/{block}/Density": 5e-7}


def two_balls(divisions, rings):
    """The upper ball is the secondary one."""
    scene = {"Mesh/Type": "Parts", **material("upper_body"), **material("lower_body"),
             "Interactions/Pair/Side Set": "upper_surface", "Interactions/Pair/Primary Side Set": "lower_surface",
             "Interactions/Pair/Cutoff": 2.0}
    for name, height in ("upper", DIAMETER + 1.2 * EQUILIBRIUM), ("lower", 0.0):
        scene.update({f"Mesh/Parts/{name}/{path}": value for path, value in shape(divisions, rings, height).items()})
    return scene


def one_ball(divisions, rings):
    """A ball of about twice as many cells of the same shape."""
    larger = round(divisions * 2 ** (1 / 3)), round(rings * 2 ** (1 / 3))
    return {**{f"Mesh/{path}": value for path, value in shape(*larger, DIAMETER / 2 + 1.2 * EQUILIBRIUM).items()},
            **material("body"), "Interactions/Wall/Side Set": "surface", "Interactions/Wall/Cutoff": 2.0,
            "Interactions/Wall/Normal": [0.0, 0.0, 1.0]}


def text_of(scene, count):
    """Returns the scene as XML, with so many steps."""
    return scene_text({**scene, **steps("Average Vector Field", 1e-3, count),
                       "Time Integrator/Average Vector Field/Interaction Points": 8,
                       "Nonlinear Solver/Tolerance": 1e-9})


def run(scene, options, count, more=()):
    """Returns the processor time and the summary of a run of so many steps. `more`: arguments of mpirun."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "scene.xml")
        file.write_text(text_of(scene, count))
        command = ["mpirun", "-np", str(options.ranks), "--oversubscribe", *more] if options.ranks > 1 else []
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([*command, options.driver, str(file), "--output", folder + "/results", "--overwrite", "--quiet"],
                       env=ENVIRONMENT, check=True)
        time = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        return time, json.loads(pathlib.Path(folder, "results/summary.json").read_text())


def measure(scene, options):
    """Returns what an increment after the first takes, and the summary."""
    first, start = run(scene, options, 1)
    last, summary = run(scene, options, 1 + options.steps)
    numbers = {"time": last - first, "Newton": summary["newton_iterations"] - start["newton_iterations"]}
    for phase in PHASES:
        numbers[phase] = summary["seconds"].get(phase, 0) - start["seconds"].get(phase, 0)
    return {name: value / options.steps for name, value in numbers.items()}, summary


def counted(scene, options, count):
    """Returns the summary of a run, and what each rank sent, by kind of call."""
    library = pathlib.Path(options.driver).resolve().parents[1] / "tests/libmessage_counter.so"
    with tempfile.NamedTemporaryFile() as file:
        _, summary = run(scene, options, count, ["-x", f"LD_PRELOAD={library}", "-x", f"MESSAGE_COUNTS={file.name}"])
        return summary, json.load(file)


def print_messages(scenes, options):
    """Prints what a rank sends in a Newton iteration after the first increment."""
    rows = []
    for name, scene in scenes.items():
        (first, before), (last, after) = counted(scene, options, 1), counted(scene, options, 1 + options.steps)
        newton = last["newton_iterations"] - first["newton_iterations"]
        counts = {kind: [(b - a) / newton for a, b in zip(before[kind], after[kind])] for kind in before}
        sends, sent = counts["send calls"], [number / 1e3 for number in counts["send bytes"]]
        reductions = sum(sum(counts[f"{kind} calls"]) for kind in ("allreduce", "reduce", "scan", "barrier"))
        others = sum(sum(counts[f"{kind} calls"]) for kind in ("broadcast", "gather", "allgather", "alltoall"))
        linear = (last["linear_iterations"] - first["linear_iterations"]) / newton
        rows.append([name, f"{last['dofs']:,}", f"{newton / options.steps:.1f}", f"{linear:.1f}",
                     f"{sum(sends) / options.ranks:.0f}", f"{max(sends):.0f}", f"{sum(sent) / options.ranks:.0f}",
                     f"{max(sent):.0f}", f"{reductions / options.ranks:.0f}", f"{others / options.ranks:.1f}"])
    print("\n".join(table(["bodies", "degrees of freedom", "Newton iterations", "CG/Newton", "messages", "most", "kB",
                           "most kB", "reductions", "other collective calls"], rows)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--driver", default=str(ROOT / "build/release/drivers/ixos"))
    parser.add_argument("--cells", default="16,10")
    parser.add_argument("--steps", type=int, default=6)
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--repeats", type=int, default=1)
    parser.add_argument("--messages", action="store_true")
    parser.add_argument("--write", default="")
    options = parser.parse_args()
    divisions, rings = map(int, options.cells.split(","))
    scenes = {"two balls": two_balls(divisions, rings), "one ball before a wall": one_ball(divisions, rings)}
    if options.write:
        pathlib.Path(options.write).write_text(text_of(scenes["two balls"], options.steps), encoding="utf-8")
        return None
    if options.messages:
        print_messages(scenes, options)
        return None
    all_runs = [{name: measure(scene, options) for name, scene in scenes.items()} for _ in range(options.repeats)]
    rows, least = [], {}
    for name in scenes:
        numbers = [runs[name][0] for runs in all_runs]
        least[name] = {key: min(n[key] for n in numbers) for key in numbers[0]}
        summary = all_runs[0][name][1]
        rows.append([name, f"{summary['elements']:,}", f"{summary['dofs']:,}", f"{least[name]['time']:.3f}",
                     f"{least[name]['Newton']:.1f}", *(f"{least[name][phase]:.3f}" for phase in PHASES)])
    print("\n".join(table(["bodies", "cells", "degrees of freedom", "an increment", "Newton iterations", *PHASES],
                          rows)))
    two, one = least.values()
    print(f"ratio of an increment: {two['time'] / one['time']:.2f}, "
          f"of a Newton iteration: {two['time'] / two['Newton'] / (one['time'] / one['Newton']):.2f}")
    return None


if __name__ == "__main__":
    main()
