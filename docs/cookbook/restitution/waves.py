"""What the vibration of a free elastic ball takes from a slow impact on a rigid wall.

Hertz's force F(t) acts at a point of the ball. Each mode of vibration that is symmetric about the axis, of frequency w
and modal mass M, with the radial displacement U at the point, ends with the energy

    |int F exp(i w t) dt|^2 U^2/(2 M).

The modes are those of Lamb (1882): displacements grad phi + curl curl (r psi) with phi = A j_l(h r) P_l and
psi = B j_l(k r) P_l, h = w/c_p, k = w/c_s, whose stresses vanish on the surface."""
import numpy as np
from scipy.integrate import solve_ivp, trapezoid
from scipy.optimize import brentq
from scipy.special import spherical_jn

NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2  # of integrals over the radius, from 0 to 1


def bessel(order, x):
    """Returns a spherical Bessel function and its first two derivatives."""
    j, d = spherical_jn(order, x), spherical_jn(order, x, derivative=True)
    return j, d, -2 * d / x - (1 - order * (order + 1) / x ** 2) * j


def displacements(order, h, k, r):
    """Returns the radial and polar displacements, and their derivatives, of A = 1 and of B = 1."""
    n = order * (order + 1)
    j, d, c = bessel(order, h * r)
    pressure = h * d, j / r, h ** 2 * c, h * d / r - j / r ** 2
    j, d, c = bessel(order, k * r)
    shear = n * j / r, j / r + k * d, n * (k * d / r - j / r ** 2), k * d / r - j / r ** 2 + k ** 2 * c
    return pressure, shear


def stresses(order, w, ratio):
    """Returns the normal and shear stresses over the shear modulus on the surface, in columns for A and B.

    w: frequency over c_s/R; ratio: c_p/c_s."""
    h = w / ratio
    (_, v, du, dv), (u2, v2, du2, dv2) = displacements(order, h, w, 1.0)
    u = h * bessel(order, h)[1]
    first = -(ratio ** 2 - 2) * h ** 2 * bessel(order, h)[0]
    return np.array([[first + 2 * du, 2 * du2], [dv - v + u, dv2 - v2 + u2]])


def modes(poisson, orders, largest):
    """Yields frequency over c_s/R, and U^2/M times the density and R^3, of the modes below a frequency."""
    ratio = (2 * (1 - poisson) / (1 - 2 * poisson)) ** 0.5
    for order in range(orders):
        def condition(w, order=order):
            matrix = stresses(order, w, ratio)
            return matrix[0, 0] if order == 0 else np.linalg.det(matrix)
        grid = np.arange(0.8, largest, 0.02)
        values = [condition(w) for w in grid]
        for i in np.nonzero(np.diff(np.sign(values)))[0]:
            w = brentq(condition, grid[i], grid[i + 1], xtol=1e-13)
            matrix = stresses(order, w, ratio)
            b = 0.0 if order == 0 else -matrix[0, 0] / matrix[0, 1]
            pressure, shear = displacements(order, w / ratio, w, NODES)
            u, v = pressure[0] + b * shear[0], pressure[1] + b * shear[1]
            mass = 4 * np.pi / (2 * order + 1) * WEIGHTS @ ((u ** 2 + order * (order + 1) * v ** 2) * NODES ** 2)
            pressure, shear = displacements(order, w / ratio, w, 1.0)
            yield w, (pressure[0] + b * shear[0]) ** 2 / mass


def hertz_pulse(mass, stiffness, speed):
    """Returns times and forces of an impact, stiffness = (4/3) E* R^(1/2), and the duration of the contact."""
    depth = (5 * mass * speed ** 2 / (4 * stiffness)) ** 0.4
    scale = depth / speed

    def slope(_, state):
        return state[1], -1.25 * max(state[0], 0) ** 1.5

    def separated(_, state):
        return state[0]
    separated.terminal, separated.direction = True, -1
    done = solve_ivp(slope, (0, 10), (0, 1), events=separated, dense_output=True, rtol=1e-12, atol=1e-14)
    time = np.linspace(0, done.t[-1], 20001)
    force = stiffness * depth ** 1.5 * np.maximum(done.sol(time)[0], 0) ** 1.5
    return time * scale, force, done.t[-1] * scale


def loss(radius, modulus, poisson, density, speed, orders=40, largest=40.0):
    """Returns the share of the energy of an impact that becomes vibration, and the duration of the contact."""
    mass = 4 / 3 * np.pi * radius ** 3 * density
    time, force, duration = hertz_pulse(mass, 4 / 3 * modulus / (1 - poisson ** 2) * radius ** 0.5, speed)
    shear = (modulus / (2 * (1 + poisson)) / density) ** 0.5
    energy = 0.0
    for w, factor in modes(poisson, orders, largest):
        spectrum = trapezoid(force * np.exp(1j * w * shear / radius * time), time)
        energy += abs(spectrum) ** 2 * factor / (2 * density * radius ** 3)
    return energy / (0.5 * mass * speed ** 2), duration
