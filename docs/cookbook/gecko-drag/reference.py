"""Forces on a pad that slides on a wall while it is peeled, by energy balance.

The whole pad slides: friction holds it with a force F_t along the wall, which is also the tension of the bonded part at
the front. The arm carries P at the angle a, P cos a = F_t. The bonded part of film-peel carries P cos a, too, so the
balance is that of the film whose far end is held, with the tension in place of the angle:
    P - F_t + (P^2 - F_t^2)/(2 E' h) = W   (Begley, Collino, Israelachvili and McMeeking 2013),
and the pad pulls with F_n = sqrt(P^2 - F_t^2) along the normal. Slip dissipates on top of W. With a threshold tau on a
bonded length l, F_t = tau l. A stiff pad has F_n = sqrt(W^2 + 2 W F_t)."""
import math

WORK = 15**(1 / 3) * math.pi / 500  # of the default law [E0 L0]
THICKNESS, POISSON = 3.0, 0.2  # of xml/gecko-drag.xml; E = 1
STIFFNESS = THICKNESS / (1 - POISSON**2)  # E' h
PEAK = 0.06244283  # largest attraction of the default law [E0]
STRESSES = 0.0, 0.00025, 0.0005, 0.001, 0.002
BONDED = 40.0


def normal_force(tangential):
    """Returns F_n for F_t."""
    released = tangential + tangential**2 / (2 * STIFFNESS) + WORK
    force = STIFFNESS * (math.sqrt(1 + 2 * released / STIFFNESS) - 1)  # P + P^2/(2 E' h) is released
    return math.sqrt(force**2 - tangential**2)


if __name__ == "__main__":
    print("stress,tangential,normal")
    for stress in STRESSES:
        print(f"{stress:g},{stress * BONDED:.6f},{normal_force(stress * BONDED):.6f}")
