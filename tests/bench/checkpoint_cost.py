#!/usr/bin/python3
"""What checkpoints cost: the strip with and without, in turns, on one rank and on two.

    tests/bench/checkpoint_cost.py [--repeats 5] [--driver build/release/drivers/ixos]

Prints, by number of ranks, the median wall-clock seconds of the time loop without checkpoints, the medians of the ratios of
neighbouring runs with one every 100 steps and one every step, and the time and size of one.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from driver_process import BENCH_ENVIRONMENT, ROOT, STEPS, driver_command  # noqa: E402


def seconds(driver, folder, ranks, settings):
    scene = os.path.join(ROOT, "xml/strip.xml")
    subprocess.run(driver_command(driver, scene, ["--output", folder], settings, ranks), env=BENCH_ENVIRONMENT, check=True)
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)["wall_seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--driver", default=os.path.join(ROOT, "build/release/drivers/ixos"))
    parser.add_argument("--repeats", type=int, default=5)
    options = parser.parse_args()
    scene = [STEPS + "Time Step=0.1", STEPS + "Final Time=60", "Output/Fields Time Interval=0"]
    cases = {"none": ["Output/Checkpoint/Keep=0"], "every 100 steps": ["Output/Checkpoint/Interval=100"],
             "every step": ["Output/Checkpoint/Interval=1"]}
    print("| ranks | none [s] | every 100 of 600 steps | every step | a checkpoint [ms] | [MB] |\n|---|---|---|---|---|---|")
    for ranks in (1, 2):
        times = {case: [] for case in cases}
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(options.repeats):
                for case, more in cases.items():
                    times[case].append(seconds(options.driver, folder, ranks, scene + more))
            size = os.path.getsize(os.path.join(folder, "checkpoint.h5")) / 1e6
        more = {case: statistics.median(t / none - 1 for t, none in zip(values, times["none"]))
                for case, values in times.items()}
        none = statistics.median(times["none"])
        print("| %d | %.2f | %+.1f %% | %+.0f %% | %.1f | %.1f |" % (
            ranks, none, 100 * more["every 100 steps"], 100 * more["every step"], more["every step"] * none / 600 * 1000,
            size), flush=True)


if __name__ == "__main__":
    main()
