"""Steady force of peeling a film by energy balance, on a frictionless wall with the film's far end held.

The arm carries the force P per width under the angle a to the wall; the bonded part slides, and carries P cos a. With
C(P) = P times stretch - energy, per length of the film in tension, a length of film that changes from bonded to free
under a fixed force releases C(P) - C(P cos a). It equals the work of adhesion W. With C = P + P^2/(2 E' h):
    P (1 - cos a) + P^2 (1 - cos^2 a)/(2 E' h) = W   (Begley, Collino, Israelachvili and McMeeking 2013).
A film that cannot slide has P^2 in place of P^2 (1 - cos^2 a) (Kendall 1975). With friction the film slips on a length
P cos a/tau behind the front, and what slip dissipates adds to W in Kendall's balance."""
import math

from scipy.optimize import brentq

WORK = 15**(1 / 3) * math.pi / 500  # of the default law [E0 L0]
THICKNESS, POISSON = 3.0, 0.2  # of xml/film-peel.xml; E = 1
STIFFNESS = THICKNESS / (1 - POISSON**2)  # E' h
MU, LAMBDA = 1 / (2 * (1 + POISSON)), POISSON / ((1 + POISSON) * (1 - 2 * POISSON))


def sliding(angle):
    """Returns the force at an angle in degrees."""
    cosine = math.cos(math.radians(angle))
    return brentq(lambda p: p * (1 - cosine) + p**2 * (1 - cosine**2) / (2 * STIFFNESS) - WORK, 0, 10)


def kendall(angle, toughness=WORK):
    """Returns the force on a film that cannot slide, for an energy per length that the front consumes."""
    cosine = math.cos(math.radians(angle))
    return brentq(lambda p: p * (1 - cosine) + p**2 / (2 * STIFFNESS) - toughness, 0, 10)


def slip_zone(angle, force, stress, stiffness):
    """Returns the length that slips behind the front at a threshold of friction. Ahead of it the film sticks by springs
    of a stiffness per area, which carry the threshold times sqrt(E' h/stiffness)."""
    return force * math.cos(math.radians(angle)) / stress - math.sqrt(STIFFNESS / stiffness)


def stretched(stretch):
    """Returns force and energy per length of a neo-Hookean film in plane strain whose faces are free."""
    def across(thinning):  # the stress across the film vanishes
        return MU * (thinning**2 - 1) + LAMBDA * math.log(stretch * thinning)
    thinning = brentq(across, 0.2, 2)
    log = math.log(stretch * thinning)
    energy = MU / 2 * (stretch**2 + thinning**2 - 2) - MU * log + LAMBDA / 2 * log**2
    return THICKNESS * (MU * (stretch**2 - 1) + LAMBDA * log) / stretch, THICKNESS * energy


def complementary(force):
    """Returns force times stretch minus energy of the neo-Hookean film: P + P^2/(2 E' h) if the strain is small."""
    stretch = brentq(lambda value: stretched(value)[0] - force, 0.9, 2)
    return force * stretch - stretched(stretch)[1]


def finite_strain(angle):
    """Returns the force of the sliding film at finite strains."""
    cosine = math.cos(math.radians(angle))
    return brentq(lambda p: complementary(p) - complementary(p * cosine) - WORK, 0.1 * WORK, 2 * sliding(angle))


if __name__ == "__main__":
    print("angle,kendall,sliding,finite_strain")
    for degrees in (180, 150, 120, 90, 60, 45, 30):
        print(f"{degrees},{kendall(degrees):.6f},{sliding(degrees):.6f},{finite_strain(degrees):.6f}")
