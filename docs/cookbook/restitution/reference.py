#!/usr/bin/python3
"""Computes reference.csv without Ixos: what waves, viscosity and adhesion take from an impact, each alone.

    docs/cookbook/restitution/reference.py > docs/cookbook/restitution/reference.csv"""
import math

import adhesion
import viscoelastic_impact
import waves

RADIUS, MODULUS, POISSON, DENSITY = 1000.0, 1.0, 0.3, 5e-7  # of xml/restitution.xml
MASS = 4 / 3 * math.pi * RADIUS ** 3 * DENSITY
STIFFNESS = MODULUS / (1 - POISSON ** 2)  # E*
BRANCH = 0.3  # shear modulus of the Maxwell branch
COLUMNS = "series", "speed", "relaxation_time", "restitution", "contact_time"


def main():
    print(",".join(COLUMNS))
    for speed in 1.0, 10.0, 50.0:
        share, duration = waves.loss(RADIUS, MODULUS, POISSON, DENSITY, speed)
        print(f"waves,{speed:g},0,{(1 - share) ** 0.5:.6f},{duration:.4f}")
    for speed, time in ((1.0, 0.3), (1.0, 3.0), (1.0, 30.0), (10.0, 3.0)):
        moduli = viscoelastic_impact.plane_modulus(MODULUS, POISSON, BRANCH, time)
        restitution, duration = viscoelastic_impact.impact(MASS, RADIUS, speed, moduli)
        print(f"viscosity,{speed:g},{time:g},{restitution:.5f},{duration:.4f}")
    for name, loss in (("adhesion", adhesion.loss(STIFFNESS)), ("adhesion JKR", adhesion.loss_jkr(STIFFNESS))):
        # the sticking speed: all of the energy is lost
        print(f"{name},{math.sqrt(2 * loss / MASS):.5f},0,0,")


if __name__ == "__main__":
    main()
