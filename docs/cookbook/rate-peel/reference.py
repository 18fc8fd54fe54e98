"""Peel force of a viscoelastic strip at 90 degrees: both elastic limits, and the first correction at high speed.

Per length the force P works as much as adhesion takes, W, the tension of the arm stores, P^2/(2 E' h), and the strip
dissipates, D:
    P = W - P^2/(2 E' h) + D,
for the complementary energy of the arm is P + P^2/(2 E' h) (docs/cookbook/film-peel). D = 0 at both limits, with E' of
the modulus after a long time or of the instantaneous one.

At high speed v the arm is an elastica with the bending stiffness B = E' h^3/12 of the instantaneous modulus. With the
angle p between arm and force its curvature is k = 2 sqrt(P/B) sin(p/2), and p falls from pi/2 at the front to 0. A
branch that has not relaxed yet stores e = mu_b dev(strain):dev(strain) per volume, and dissipates 2 e/tau. A point of
the strip passes the bend at the speed v, therefore
    D = 2 m (h^3/12)/(v tau) integral of k^2 ds,   integral of k dp = 4 (1 - cos(pi/4)) sqrt(P/B),
with m = e over the square of the strain along the strip (first order in 1/(v tau); derived here)."""
import math

from scipy.optimize import brentq

WORK = 15**(1 / 3) * math.pi / 500  # of the default law [E0 L0]
THICKNESS, SHEAR, POISSON, BRANCH, TIME = 2.0, 0.36, 0.4, 0.72, 10.0  # of xml/rate-peel.xml
BULK = 2 * SHEAR * (1 + POISSON) / (3 * (1 - 2 * POISSON))


def poisson(shear):
    """Returns Poisson's ratio of this shear modulus and the strip's bulk modulus."""
    return (3 * BULK - 2 * shear) / (2 * (3 * BULK + shear))


def modulus(shear):
    """Returns E/(1 - nu^2)."""
    return 2 * shear / (1 - poisson(shear))


def force(shear, dissipated=lambda p: 0.0):
    """Returns the force of a strip with this shear modulus, that dissipates `dissipated`(force) per length."""
    return brentq(lambda p: p + p**2 / (2 * modulus(shear) * THICKNESS) - WORK - dissipated(p), 1e-6, 1)


def fast(speed):
    """Returns the force at a high speed."""
    shear = SHEAR + BRANCH
    across = poisson(shear) / (1 - poisson(shear))  # contraction of the thickness over the strain, in plane strain
    share = BRANCH * (1 + across**2 - (1 - across)**2 / 3)
    inertia = THICKNESS**3 / 12

    def dissipated(p):
        bend = 4 * (1 - math.cos(math.pi / 4)) * math.sqrt(p / (modulus(shear) * inertia))
        return 2 * share * inertia * bend / (speed * TIME)
    return force(shear, dissipated)


if __name__ == "__main__":
    print("speed,force")
    print(f"0,{force(SHEAR):.6f}")
    for given in (10, 100):
        print(f"{given},{fast(given):.6f}")
    print(f"inf,{force(SHEAR + BRANCH):.6f}")
