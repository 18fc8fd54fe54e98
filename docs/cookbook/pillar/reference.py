"""Pull-off force of a pillar with a round defect in the middle of its foot, by Dugdale's model of a penny-shaped crack.

On a frictionless wall the foot is a plane of symmetry: the defect is a crack of radius c in a bar of twice the length.
Its surfaces attract each other with the strength s0 until the gap of one half reaches W/s0. In a large body under the
stress s the gap at the crack's edge is (4/pi) (s0/E') c [1 - sqrt(1 - (s/s0)^2)] (Maugis 1992; half of the opening), so
    s/s0 = sqrt(1 - (1 - q)^2), q = pi E' W/(4 s0^2 c), where q < 1, and 1 for smaller defects.
Large defects: s = sqrt(pi E' W/(2 c)), Griffith's stress (Sneddon 1946). In a bar of radius b the stress intensity is Y
times as large (Benthem and Koiter 1973), and s smaller. The force is at most s0 times the area that adheres."""
import math

RADIUS, STRENGTH, WORK, YOUNG, POISSON = 300.0, 0.02, 0.005, 1.0, 0.3  # of xml/pillar.xml
BARRIER_STIFFNESS, BARRIER_GAP = 100.0, 4e-4  # the wall takes a little of the work
EFFECTIVE_WORK = WORK - STRENGTH * BARRIER_GAP + STRENGTH**2 / (2 * BARRIER_STIFFNESS)
DEFECTS = (5, 10, 20, 40, 75, 120)


def bar(defect):
    """Returns Y: the stress intensity of the bar over that of a large body, under the same force."""
    r = defect / RADIUS
    return math.sqrt(1 - r) * (1 + r / 2 - 5 / 8 * r**2 + 0.421 * r**3) / (1 - r**2)


def size(defect):
    """Returns q, which decreases with the defect."""
    return math.pi * YOUNG / (1 - POISSON**2) * EFFECTIVE_WORK / (4 * STRENGTH**2 * defect)


def strength(defect):
    """Returns the largest force: the strength times the area that adheres."""
    return STRENGTH * math.pi * (RADIUS**2 - defect**2)


def griffith(defect):
    """Returns the pull-off force if a sharp crack decided alone."""
    return STRENGTH * math.sqrt(2 * size(defect)) / bar(defect) * math.pi * RADIUS**2


def pull_off(defect):
    """Returns the pull-off force."""
    q = min(size(defect), 1)
    return min(STRENGTH * math.sqrt(1 - (1 - q)**2) / bar(defect) * math.pi * RADIUS**2, strength(defect))


if __name__ == "__main__":
    print("defect,strength,griffith,pull_off")
    for c in DEFECTS:
        print(f"{c},{strength(c):.2f},{griffith(c):.2f},{pull_off(c):.2f}")
