#!/usr/bin/python3
"""Measures what a step costs when Python drives it.

    PYTHONPATH=build/release/python tests/bench/python_overhead.py [--check]

A ball of 8 cells flies freely; Central Difference takes microseconds a step. `steps(n, dt)` loops in C++, `step(dt)` n
times in Python: the difference is the price of Python's call. With --check the exit status is 1 if that is 5
microseconds or more.
"""
import pathlib
import sys
import time

import ixos

BALL = pathlib.Path(__file__).resolve().parents[2] / "xml/ball.xml"
COUNT = 20000


def seconds(call):
    """The least time of five calls, over the number of steps."""
    times = []
    for _ in range(5):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times) / COUNT


def main():
    scene = ixos.Scene(BALL)
    scene.time_integrator.type = "Central Difference"
    scene.mesh.disk.core_divisions = 2
    scene.mesh.disk.rings = 1
    del scene["Interactions"]
    simulation = scene.simulation()
    dt = simulation.stable_step(1e-3) / 4

    def in_python():
        for _ in range(COUNT):
            simulation.step(dt)

    def with_a_look():
        for _ in range(COUNT):
            simulation.step(dt)
            simulation.u

    inside, outside = seconds(lambda: simulation.steps(COUNT, dt)), seconds(in_python)
    looking = seconds(with_a_look)
    simulation.observers.append(lambda now: None)
    observed = seconds(in_python)
    for what, value in (("a step, looped in C++", inside), ("Python's call of step()", outside - inside),
                        ("a view of u", looking - outside), ("an observer", observed - outside)):
        print(f"{what:25} {1e6 * value:6.2f} us")
    return "--check" in sys.argv and outside - inside >= 5e-6


if __name__ == "__main__":
    sys.exit(main())
