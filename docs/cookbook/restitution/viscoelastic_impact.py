"""Impact of a viscoelastic ball on a rigid wall: Hertz's contact with a relaxing modulus, after Lee and Radok (1960)
while the contact grows, and after Ting (1966) while it shrinks.

    F(t) = (4/3) R^(1/2) int_0^s E*(t - t') d delta^(3/2)(t'),   s = t while the contact grows;

after that s(t) is the time at which the contact had the radius of now, from int_s^t E*(t - t') d delta(t') = 0."""
import numpy as np


def plane_modulus(modulus, poisson, branch, relaxation_time):
    """Returns E* after a long time, and decaying parts and decay times, for a shear modulus with one Maxwell branch.

    E*(p) = 4 G (3 K + G)/(3 K + 4 G) with G(p) = mu + branch p tau/(1 + p tau); the bulk modulus K is elastic."""
    shear, bulk = modulus / (2 * (1 + poisson)), modulus / (3 * (1 - 2 * poisson))

    def star(g):
        return 4 * g * (3 * bulk + g) / (3 * bulk + 4 * g)
    # The poles in p are those of G and of 1/(3 K + 4 G); the parts add to the jump from long to short times.
    slow = (3 * bulk + 4 * shear) / (3 * bulk + 4 * (shear + branch)) / relaxation_time
    fast = shear + branch
    first = branch  # of G in 4 G (3 K + G)/(3 K + 4 G) = G + 9 K G/(3 K + 4 G) = G + 9 K/4 - 27 K^2/(4 (3 K + 4 G))
    second = star(fast) - star(shear) - first
    return star(shear), np.array([first, second]), np.array([relaxation_time, 1 / slow])


def impact(mass, radius, speed, moduli, steps=4000):
    """Returns the restitution and the duration of the contact.

    moduli: E* after a long time, decaying parts and their decay times, of plane_modulus()."""
    long, parts, times = moduli
    scale = (mass ** 2 / ((long + parts.sum()) ** 2 * radius * speed)) ** 0.2
    dt = 4 * scale / steps
    factor = 4 / 3 * radius ** 0.5
    decay = np.exp(-dt / times)
    mean = times / dt * (1 - decay)  # of exp(-(t - t')/times) over the step just made

    def relaxed(state, change):
        """Returns the integrals of the decaying parts after a step in which the integrand changes by a value."""
        return decay * state + parts * mean * change

    depth, velocity, force = [0.0], speed, 0.0
    growing = np.zeros(2)
    while True:  # the contact grows: Heun's method
        ahead = depth[-1] + dt * velocity - 0.5 * dt ** 2 * force / mass
        if ahead <= depth[-1]:
            break
        growing = relaxed(growing, ahead ** 1.5 - depth[-1] ** 1.5)
        new = factor * (long * ahead ** 1.5 + growing.sum())
        velocity -= 0.5 * dt * (force + new) / mass
        force = new
        depth.append(ahead)
    turn = len(depth) - 1
    path = np.array(depth)
    past = np.arange(turn + 1) * dt
    # The integrals up to each time s of the growing contact, of delta^(3/2) and of delta, as seen at that time.
    cubes, lengths = np.zeros((turn + 1, 2)), np.zeros((turn + 1, 2))
    for i in range(turn):
        cubes[i + 1] = relaxed(cubes[i], path[i + 1] ** 1.5 - path[i] ** 1.5)
        lengths[i + 1] = relaxed(lengths[i], path[i + 1] - path[i])
    now, total, step = path[-1], lengths[-1], turn
    while now > 0:
        ahead = now + dt * velocity - 0.5 * dt ** 2 * force / mass
        total, step, now = relaxed(total, ahead - now), step + 1, ahead
        fade = np.exp(-(step * dt - past)[:, None] / times)
        # int_s^t E* d delta as a function of s; its zero is the time of equal radius
        rest = long * (now - path) + (total - lengths * fade).sum(axis=1)
        negative = np.nonzero(rest[:-1] > 0)[0]
        zero = negative[-1] if len(negative) else 0
        if rest[zero] <= 0:
            break
        part = rest[zero] / (rest[zero] - rest[zero + 1])
        integrals = long * path ** 1.5 + (cubes * fade).sum(axis=1)
        new = factor * ((1 - part) * integrals[zero] + part * integrals[zero + 1])
        velocity -= 0.5 * dt * (force + new) / mass
        force = new
    return -velocity / speed, step * dt
