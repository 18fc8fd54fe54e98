"""Compliance of a pillar on a backing: an upper bound, and how it grows with the height.

The bar of height h and radius a gives way by h/(pi a^2 E). A half-space under a constant pressure on the circle gives
way, in the mean, by (16/3)/pi^2 (1 - nu^2)/(E a) (Johnson 1985, Contact Mechanics, 3.4). Both stress fields together
are in balance, and the true one has the least complementary energy: the sum is an upper bound of the compliance. What
the joint adds does not depend on the height if the pillar is higher than wide (Saint-Venant): between two such heights
the compliance grows as that of the bar."""
import math

RADIUS, YOUNG, POISSON = 300.0, 1.0, 0.3  # of xml/pillar-backing.xml
HEIGHTS = (300, 600, 1200, 2400)


def bar(height):
    """Returns the compliance of the pillar alone [displacement/force]."""
    return height / (math.pi * RADIUS**2 * YOUNG)


def half_space():
    """Returns that of the half-space under a constant pressure."""
    return 16 / (3 * math.pi**2) * (1 - POISSON**2) / (YOUNG * RADIUS)


if __name__ == "__main__":
    print("height,bar,bound")
    for h in HEIGHTS:
        print(f"{h},{1e6 * bar(h):.2f},{1e6 * (bar(h) + half_space()):.2f}")
