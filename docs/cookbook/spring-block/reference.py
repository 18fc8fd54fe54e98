"""Closed forms of a rigid block on a wall with friction, in units of xml/spring-block.xml.

A spring k pulls the block, of mass m, at the speed V. The block sticks until the spring's force is the threshold F, at
the time F/(k V). Then m x'' = k (V t - x) - F as long as it slides. It starts at rest, so
    k (V t - x) = F + V sqrt(k m) sin(omega (t - F/(k V))),   omega = sqrt(k/m),
    x' = V (1 - cos(omega (t - F/(k V)))) >= 0:
the block never sticks again, and the swing neither decays nor grows. A block that is pushed at the speed v stops after
m v^2/(2 F), when its energy is spent."""
import math

import numpy as np

LENGTH, HEIGHT, DENSITY, STRESS, SPRING = 20.0, 10.0, 4e-6, 2e-4, 0.02
MASS = DENSITY * LENGTH * HEIGHT
THRESHOLD = STRESS * LENGTH
OMEGA = math.sqrt(SPRING / MASS)
SPEEDS = 0.5, 1.0, 2.0


def first_slip(speed):
    """Returns the time at which the block starts to slide."""
    return THRESHOLD / (SPRING * speed)


def swing(speed):
    """Returns the amplitude of the spring's force about the threshold."""
    return speed * math.sqrt(SPRING * MASS)


def spring_force(time, speed):
    """Returns the spring's force at times, as an array."""
    after = time - first_slip(speed)
    return np.where(after < 0, SPRING * speed * time, THRESHOLD + swing(speed) * np.sin(OMEGA * after))


def stop(speed):
    """Returns the way of a block that is pushed."""
    return MASS * speed**2 / (2 * THRESHOLD)


if __name__ == "__main__":
    print("speed,first_slip,least,largest,stop")
    for value in SPEEDS:
        print(f"{value:g},{first_slip(value):g},{THRESHOLD - swing(value):g},{THRESHOLD + swing(value):g},"
              f"{stop(value):g}")
