#!/usr/bin/python3
"""States from arrays: what follows from them, and what is refused; on any number of ranks."""
import unittest

import numpy as np
from support import BALL, free_block, ixos, main, pulled_block

AREA, DENSITY = 8.0, 3.0
SPIN = np.array([[0, -1], [1, 0]])  # of 1 radian each T0


def spinning(simulation, drift):
    """Velocities of a rigid body that turns about the origin and drifts."""
    return simulation.points @ SPIN.T + drift


class SetStateTest(unittest.TestCase):
    def test_a_body_moves_as_its_state_says(self):
        simulation = free_block((0, 0)).simulation()
        simulation.set_state(u=np.full(simulation.u.shape, 7), v=np.tile([2, 1], (len(simulation.v), 1)))
        simulation.steps(5, 0.01)
        np.testing.assert_allclose(simulation.u, np.tile([7.1, 7.05], (len(simulation.u), 1)), atol=1e-12)

    def test_energy_and_momenta_are_those_of_the_state(self):
        simulation = free_block((0, 0)).simulation()
        simulation.set_state(v=spinning(simulation, (2, 0)))
        # At the centre (2, 1) v is (1, 2); the inertia of a rectangle of 4 x 2 about its centre is m (16 + 4)/12.
        mass = AREA * DENSITY
        self.assertAlmostEqual(simulation.energies["kinetic_energy"], mass * 5 / 2 + mass * 20 / 12 / 2, places=11)
        np.testing.assert_allclose(simulation.linear_momentum, [mass, 2 * mass], atol=1e-11)
        np.testing.assert_allclose(simulation.angular_momentum, [mass * (2 * 2 - 1) + mass * 20 / 12], atol=1e-10)

    def test_a_saved_state_is_a_beginning(self):
        scene = ixos.Scene(BALL).set("Time Integrator/Type=Newmark")
        whole, half = scene.simulation(), scene.simulation()
        half.steps(5, 0.001)
        other = scene.simulation()
        other.set_state(half.u, half.v, half.time)
        self.assertEqual(other.time, half.time)
        whole.steps(10, 0.001)
        other.steps(5, 0.001)
        np.testing.assert_allclose(other.u, whole.u, rtol=0, atol=1e-9 * abs(whole.u).max())

    def test_sums_begin_at_zero(self):
        simulation = pulled_block().simulation()
        simulation.steps(4, 0.25)
        self.assertGreater(simulation.energies["external_work"], 0.001)
        simulation.set_state(u=np.zeros(simulation.u.shape), time=0)
        self.assertEqual((simulation.time, simulation.energies["external_work"]), (0, 0))
        simulation.steps(4, 0.25)
        self.assertAlmostEqual(simulation.energies["external_work"], 8 / 2 * (0.04 / 4) ** 2 * AREA, places=12)

    def test_ghosts_take_their_owners_values(self):
        simulation = free_block((0, 0)).simulation()
        u = np.full(simulation.u.shape, np.nan)
        u[:simulation.owned_nodes] = 3
        simulation.set_state(u=u)
        np.testing.assert_array_equal(simulation.u, np.full(u.shape, 3))

    def test_views_stay_valid(self):
        simulation, places = free_block().simulation(), set()
        for _ in range(4):
            simulation.step()
            places |= {simulation.u.ctypes.data, simulation.v.ctypes.data}
        simulation.set_state(u=simulation.u, v=simulation.v)
        self.assertLessEqual({simulation.u.ctypes.data, simulation.v.ctypes.data}, places)

    def test_constrained(self):
        simulation = pulled_block().simulation()
        x, y = simulation.points.T
        np.testing.assert_array_equal(simulation.constrained, np.stack([(x == 0) | (x == 4), y == 0], axis=-1))


class RefusalTest(unittest.TestCase):
    def refuse(self, simulation, words, **state):
        before = simulation.u.copy(), simulation.v.copy(), simulation.time
        with self.assertRaises(ixos.InputError) as caught:
            simulation.set_state(**state)
        self.assertIn(words, str(caught.exception))
        np.testing.assert_array_equal(simulation.u, before[0])
        np.testing.assert_array_equal(simulation.v, before[1])
        self.assertEqual(simulation.time, before[2])

    def test_arrays_that_do_not_fit(self):
        simulation = free_block().simulation()
        simulation.step()
        zero = np.zeros(simulation.u.shape)
        self.refuse(simulation, ", 2) is needed, nodes x dimension", u=zero[:-1])
        self.refuse(simulation, "the array has the shape", v=zero.ravel())
        self.refuse(simulation, "an array of numbers is needed", v="fast")
        self.refuse(simulation, "an array of numbers is needed", u=zero.astype(complex))

    def test_numbers_that_are_not_finite(self):
        simulation = free_block().simulation()
        for value in (np.nan, np.inf):
            v = np.zeros(simulation.v.shape)
            v[2, 1] = value
            self.refuse(simulation, f"{value} is not a finite number", v=v)
        self.refuse(simulation, "v[2, 1]", v=v)
        for time in (np.nan, -1, 7):
            self.refuse(simulation, "is not within the scene's times, 0 to 0.1", time=time)

    def test_values_that_are_prescribed_otherwise(self):
        simulation = pulled_block().simulation()
        u = 0.01 * simulation.points
        self.refuse(simulation, "is not possible; the scene's Boundary Conditions prescribe 0 at t = 0 T0", u=u)
        u[simulation.constrained] = 0
        simulation.set_state(u=u)
        self.refuse(simulation, "prescribe 0.04 at t = 1 T0", u=u, time=1)
        self.refuse(simulation, 'v: the scheme "Static" has no velocities', v=np.where(simulation.constrained, 0, 1))

    def test_inadmissible_places(self):
        ball = ixos.Scene(BALL).simulation()
        self.refuse(ball, "u: it is not admissible", u=np.tile([0, -100], (len(ball.u), 1)))
        self.refuse(ball, "u: it is not admissible", u=ball.points * [-2, 0])  # a mirror image

    def test_a_state_whose_acceleration_overflows(self):
        scene = free_block()
        scene.materials.Rubber.model = "Linear Elastic"
        scene.materials.Rubber.mass_damping = 0.5
        simulation, other = scene.simulation(), scene.simulation()
        for one in (simulation, other):
            self.assertEqual(one.steps(4, 0.01), 4)
        # All forces are finite, of about 1e200 E0 L0, but the square of the acceleration is not.
        self.refuse(simulation, "the acceleration cannot be solved for", u=1e200 * simulation.points, time=0.05)
        np.testing.assert_array_equal(simulation.a, other.a)
        self.assertEqual(simulation.energies, other.energies)
        self.assertGreater(other.energies["dissipated_energy"], 0)
        for one in (simulation, other):
            self.assertEqual(one.steps(4, 0.01), 4)
        np.testing.assert_array_equal(simulation.u, other.u)
        self.assertEqual(simulation.energies, other.energies)

    def test_a_refusal_on_one_rank_is_one_on_all(self):
        simulation = free_block().simulation()
        v = np.zeros(simulation.v.shape)
        if simulation.rank == simulation.ranks - 1:
            v[0, 0] = np.nan
        self.refuse(simulation, "v[0, 0]" if simulation.ranks == 1 else "v[0, 0] on rank 1", v=v)


if __name__ == "__main__":
    main()
