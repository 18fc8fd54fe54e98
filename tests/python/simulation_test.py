#!/usr/bin/python3
"""Steps, views and measures, on any number of ranks."""
import gc
import threading
import unittest
import weakref

import numpy as np
from support import BALL, MINE, free_block, ixos, main, pulled_block

AREA, DENSITY = 8.0, 3.0


def total(simulation, values):
    """The sum over all ranks, each owned node once."""
    own = values[:simulation.owned_nodes].sum(axis=0)
    if simulation.ranks == 1:
        return own
    from mpi4py import MPI
    return MPI.COMM_WORLD.allreduce(own)


class StepTest(unittest.TestCase):
    def test_a_free_body_flies_straight(self):
        simulation = free_block().simulation()
        for _ in range(10):
            self.assertTrue(simulation.step(0.01))
        self.assertAlmostEqual(simulation.time, 0.1, places=15)
        np.testing.assert_allclose(simulation.u, np.tile([0.1, -0.2], (len(simulation.u), 1)), atol=1e-13)
        np.testing.assert_allclose(simulation.v, np.tile([1, -2], (len(simulation.v), 1)), atol=1e-12)
        np.testing.assert_allclose(simulation.a, 0, atol=1e-10)

    def test_energies_and_momenta_are_those_of_a_rigid_body(self):
        simulation = free_block().simulation()
        simulation.step()
        self.assertAlmostEqual(simulation.energies["kinetic_energy"], AREA * DENSITY * 5 / 2, places=10)
        self.assertAlmostEqual(simulation.energies["elastic_energy"], 0, places=12)
        np.testing.assert_allclose(simulation.linear_momentum, np.array([1, -2]) * AREA * DENSITY, atol=1e-10)
        # The centre is at (x, y) + u; its angular momentum is m (x v_y - y v_x).
        x, y = total(simulation, simulation.points + simulation.u) / total(simulation, np.ones(len(simulation.u)))
        np.testing.assert_allclose(simulation.angular_momentum, [AREA * DENSITY * (-2 * x - y)], atol=1e-9)

    def test_reactions_are_stress_times_width(self):
        simulation = pulled_block().simulation()
        while simulation.time < 1 - 1e-12:
            self.assertTrue(simulation.step())
        force = 8 * 0.04 / 4 * 2  # E times strain times width
        np.testing.assert_allclose(simulation.reaction("right"), [force, 0], atol=1e-12)
        np.testing.assert_allclose(simulation.reaction("left"), [-force, 0], atol=1e-12)
        right = simulation.reactions[simulation.points[:simulation.owned_nodes, 0] == simulation.points[:, 0].max()]
        if simulation.ranks == 1:
            self.assertAlmostEqual(right[:, 0].sum(), force, places=12)

    def test_forces_balance(self):
        pulled = pulled_block().simulation()
        while pulled.time < 1 - 1e-12:
            self.assertTrue(pulled.step())
        own = slice(pulled.owned_nodes)
        np.testing.assert_allclose(pulled.elastic_forces[own], pulled.reactions, atol=1e-11)
        np.testing.assert_array_equal(pulled.interaction_forces, np.zeros(pulled.u.shape))
        ball = ixos.Scene(BALL).simulation()
        ball.steps(50, 0.001)
        force = ball.contact["contact_force"]
        self.assertLess(force[1], 0)  # the wall attracts
        np.testing.assert_allclose(total(ball, ball.interaction_forces), -force, rtol=1e-12, atol=1e-15)
        wall = ball.interaction("Wall")  # the only one
        np.testing.assert_array_equal(wall["contact_force"], force)
        self.assertEqual(wall["min_gap"], ball.contact["min_gap"])
        self.assertEqual(wall["contact_measure"], ball.contact["contact_measure"])
        x, y = (ball.points + ball.u).T
        f_x, f_y = -ball.interaction_forces.T
        np.testing.assert_allclose(wall["contact_moment"], [total(ball, x * f_y - y * f_x)], rtol=1e-12, atol=1e-13)
        with self.assertRaisesRegex(ixos.InputError, 'interaction "Wal" does not exist; did you mean "Wall"?'):
            ball.interaction("Wal")
        np.testing.assert_allclose(total(ball, ball.elastic_forces), 0, atol=1e-13)
        # The momentum of the ball grows at the rate of the wall's force.
        before, time = ball.linear_momentum, ball.time
        ball.step(1e-6)
        np.testing.assert_allclose((ball.linear_momentum - before) / (ball.time - time), force, rtol=1e-4, atol=1e-9)

    def test_attempts_leave_no_trace(self):
        simulation, other = free_block().simulation(), free_block().simulation()
        self.assertTrue(simulation.attempt(0.02))
        self.assertTrue(simulation.attempt(0.01))
        self.assertEqual(simulation.time, 0)
        simulation.accept()
        other.step(0.01)
        np.testing.assert_array_equal(simulation.u, other.u)
        for judge in (simulation.accept, simulation.error, simulation.gap_ratio):
            with self.assertRaisesRegex(RuntimeError, "no attempted step"):
                judge()
        simulation.attempt(0.01)
        self.assertEqual(simulation.gap_ratio(), 1)  # there is no wall
        self.assertLess(simulation.error(), 1e-12)  # a straight flight

    def test_a_step_that_fails_is_false_and_changes_nothing(self):
        scene = ixos.Scene(BALL)
        scene.mesh.disk.center = [0, 5.2]
        scene.nonlinear_solver.maximum_iterations = 1
        simulation = scene.simulation()
        before = simulation.u.copy()
        result = simulation.step(0.05)
        self.assertFalse(result)
        self.assertTrue(result.reason)
        self.assertEqual(simulation.time, 0)
        np.testing.assert_array_equal(simulation.u, before)

    def test_observers_are_called_after_each_accepted_step(self):
        simulation, times = free_block().simulation(), []
        simulation.observers.append(lambda now: times.append(now.time))
        simulation.step(0.01)
        simulation.attempt(0.02)
        self.assertEqual(times, [0.01])
        simulation.accept()
        self.assertEqual(simulation.steps(3, 0.01), 3)
        np.testing.assert_allclose(times, [0.01, 0.03, 0.04, 0.05, 0.06], rtol=1e-15)

    def test_an_observer_may_remove_itself(self):
        simulation, calls = free_block().simulation(), []

        def once(now):
            calls.append("once")
            now.observers.remove(once)

        simulation.observers.extend([once, lambda now: calls.append("always")])
        simulation.steps(2, 0.01)
        self.assertEqual(calls, ["once", "always", "always"])

    def test_a_simulation_in_its_own_observer_is_collected(self):
        simulation = free_block().simulation()
        simulation.observers.append(lambda now, mine=simulation: mine.time)
        simulation.step()
        gone = weakref.ref(simulation.observers[0])
        del simulation
        gc.collect()
        self.assertIsNone(gone())

    def test_an_observer_cannot_change_the_simulation(self):
        simulation, refused = free_block().simulation(), []

        def meddle(now):
            for call in (now.step, lambda: now.attempt(0.01), lambda: now.steps(1, 0.01), lambda: now.run("none"),
                         lambda: now.set_state(v=now.v)):
                with self.assertRaisesRegex(RuntimeError, "an observer may read it, but not change it"):
                    call()
                refused.append(now.time)

        simulation.observers.append(meddle)
        self.assertEqual(simulation.steps(2, 0.01), 2)
        np.testing.assert_allclose(refused, 5 * [0.01] + 5 * [0.02])
        simulation.observers.clear()
        self.assertTrue(simulation.step(0.01))

    def test_an_observers_exception_leaves_the_step_accepted(self):
        simulation = free_block().simulation()
        simulation.observers.append(lambda now: now.nothing)
        for call in (lambda: simulation.step(0.01), lambda: simulation.steps(5, 0.01)):
            with self.assertRaisesRegex(AttributeError, "nothing"):
                call()
        self.assertAlmostEqual(simulation.time, 0.02, places=15)

    def test_steps_with_and_without_observers_are_the_same(self):
        one, other = (ixos.Scene(BALL).simulation() for _ in range(2))
        other.observers.append(lambda now: None)
        self.assertEqual((one.steps(20, 0.001), other.steps(20, 0.001)), (20, 20))
        np.testing.assert_array_equal(one.u, other.u)

    def test_another_thread_waits(self):
        def make(scene):
            return scene.simulation(comm=MINE)  # threads of several ranks would have to agree on who is first

        simulation, other = make(ixos.Scene(BALL)), make(free_block())
        refused = []
        thread = threading.Thread(target=lambda: simulation.steps(10000, 1e-5))
        thread.start()
        while thread.is_alive() and not refused:
            for call in (lambda: simulation.u, lambda: simulation.energies, other.step, lambda: make(free_block())):
                try:
                    call()
                except RuntimeError as error:
                    refused.append(str(error))
        thread.join()
        self.assertEqual(set(refused), {"another thread computes with Ixos; wait until it is done"})
        self.assertGreater(simulation.energies["kinetic_energy"], 0)

    def test_unknown_names_are_refused_with_the_nearest(self):
        simulation = ixos.Scene(BALL).set("Output/Probes/Top/Point={0, 12.2547}").simulation()
        self.assertEqual(simulation.probe("Top")["u"].shape, (2,))
        for call, words in ((lambda: simulation.probe("Tip"), 'probe "Tip" does not exist; did you mean "Top"?'),
                            (lambda: simulation.reaction("centre"), 'did you mean "center"?'),
                            (lambda: simulation.node_set("surfase"), 'did you mean "surface"?')):
            with self.assertRaises(ixos.InputError) as caught:
                call()
            self.assertIn(words, str(caught.exception))

    def test_steps_must_be_positive(self):
        simulation = free_block().simulation()
        for call in (simulation.step, simulation.attempt, lambda dt: simulation.steps(1, dt)):
            for dt in (0, -1, float("nan"), float("inf")):
                with self.assertRaisesRegex(ixos.InputError, f"dt: a step of {dt} T0 .* finite and greater than 0"):
                    call(dt)

    def test_a_number_of_steps_must_not_be_negative(self):
        simulation = free_block().simulation()
        with self.assertRaisesRegex(ixos.InputError, "count: -1 steps are not possible; at least 0 are allowed"):
            simulation.steps(-1, 0.01)
        self.assertEqual((simulation.steps(0, 0.01), simulation.time), (0, 0))


class ViewTest(unittest.TestCase):
    def test_views_are_the_same_memory(self):
        simulation = free_block().simulation()
        simulation.step()
        for name in ("u", "v", "a", "points", "mesh_nodes"):
            first, second = getattr(simulation, name), getattr(simulation, name)
            self.assertFalse(first.flags.owndata, name)
            self.assertEqual(first.ctypes.data, second.ctypes.data, name)
            self.assertTrue(np.shares_memory(first, second), name)
            with self.assertRaises(ValueError):
                first[0] = 1

    def test_the_present_state_is_one_of_two_places(self):
        simulation, places = free_block().simulation(), set()
        for _ in range(20):
            simulation.step()
            places.add(simulation.u.ctypes.data)
        self.assertEqual(len(places), 2)

    def test_a_view_keeps_its_simulation(self):
        simulation = free_block().simulation()
        simulation.step(0.01)
        view, nodes = simulation.u, simulation.blocks[0].nodes
        del simulation
        gc.collect()
        np.testing.assert_allclose(view, np.tile([0.01, -0.02], (len(view), 1)), atol=1e-14)
        self.assertEqual(nodes.shape[1], 4)

    def test_computed_arrays_stay(self):
        simulation = ixos.Scene(BALL).simulation()
        gaps = simulation.gaps[:simulation.owned_nodes]
        for _ in range(5):
            simulation.step(0.001)
        there = np.isfinite(gaps)  # the wall is the line y = 0
        np.testing.assert_allclose(gaps[there], simulation.points[:simulation.owned_nodes][there, 1], atol=1e-14)
        self.assertEqual(total(simulation, np.isfinite(simulation.gaps).astype(float)), 16)
        self.assertEqual(simulation.traction.shape, simulation.u.shape)
        self.assertEqual(simulation.pressure.shape, simulation.gaps.shape)

    def test_ranks_share_the_nodes(self):
        simulation = free_block().simulation()
        self.assertEqual(total(simulation, np.ones(len(simulation.u))), 5 * 3)
        self.assertEqual(total(simulation, simulation.mesh_nodes.astype(float)), sum(range(15)))


if __name__ == "__main__":
    main()
