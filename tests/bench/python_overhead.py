#!/usr/bin/python3
"""Measures what a step costs when Python drives it.

    PYTHONPATH=build/release/python tests/bench/python_overhead.py [--check]

A ball of 8 cells flies freely; Central Difference takes microseconds a step. `steps(n, dt)` loops in C++ without the
interpreter; the other loops call `step(dt)` n times from Python. The difference is the price of Python: with --check
the exit status is 1 if a step, a view of u and an observer together cost 5 microseconds or more.
"""
import pathlib
import statistics
import sys
import time

import ixos

BALL = pathlib.Path(__file__).resolve().parents[2] / "xml/ball.xml"
COUNT = 5000
ROUNDS = 15
LIMIT = 5e-6


def flying_ball():
    """Returns a simulation and a stable step."""
    scene = ixos.Scene(BALL)
    scene.time_integrator.type = "Central Difference"
    scene.mesh.disk.core_divisions = 2
    scene.mesh.disk.rings = 1
    scene.initial_conditions = {"Velocity": [1, -2], "Velocity Gradient": [0, -1, 1, 0]}
    del scene["Interactions"]
    simulation = scene.simulation()
    return simulation, simulation.stable_step(1e-3) / 4


def loops(simulation, dt):
    """Returns functions that take COUNT steps each, by what they measure."""
    def in_cpp():
        return simulation.steps(COUNT, dt)

    def in_python():
        return sum(simulation.step(dt).converged for _ in range(COUNT))

    def with_a_view():
        accepted = 0
        for _ in range(COUNT):
            accepted += simulation.step(dt).converged
            simulation.u  # pylint: disable=pointless-statement
        return accepted

    def observed():
        simulation.observers.append(lambda now: None)
        accepted = in_python()
        simulation.observers.clear()
        return accepted

    return {"C++": in_cpp, "step": in_python, "view": with_a_view, "observer": observed}


def seconds(call):
    """Returns the time of one step of a loop. The loop must have taken all its steps."""
    start = time.perf_counter()
    accepted = call()
    duration = time.perf_counter() - start
    if accepted != COUNT:
        raise RuntimeError(f"{accepted} of {COUNT} steps were accepted")
    return duration / COUNT


def main():
    simulation, dt = flying_ball()
    calls = loops(simulation, dt)
    # Neighbours in time are compared, and the median taken, because other work on the machine comes and goes.
    rounds = [{name: seconds(call) for name, call in calls.items()} for _ in range(ROUNDS)]

    def median(first, second=None):
        return statistics.median(times[first] - (times[second] if second else 0) for times in rounds)

    costs = {"a step, looped in C++": median("C++"), "Python's call of step()": median("step", "C++"),
             "a view of u": median("view", "step"), "an observer": median("observer", "step")}
    for what, cost in costs.items():
        print(f"{what:25} {1e6 * cost:6.2f} us")
    if abs(simulation.v).max() < 1 or not simulation.time > 0:
        raise RuntimeError("the ball does not fly")
    return "--check" in sys.argv and sum(list(costs.values())[1:]) >= LIMIT


if __name__ == "__main__":
    sys.exit(main())
