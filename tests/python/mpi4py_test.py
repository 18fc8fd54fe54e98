#!/usr/bin/python3
"""mpi4py beside Ixos: imported before or after, its communicators, a part of the ranks; two ranks."""
import shutil
import sys
import tempfile
import unittest

if "--first" in sys.argv:
    sys.argv.remove("--first")
    from mpi4py import MPI
    import support  # noqa: F401
else:
    import support  # noqa: F401
    from mpi4py import MPI
import numpy as np
from support import BALL, ixos, main

WORLD = MPI.COMM_WORLD


class CommunicatorTest(unittest.TestCase):
    def test_all_ranks_share_a_simulation(self):
        simulation = ixos.Scene(BALL).simulation(comm=WORLD)
        self.assertEqual((simulation.rank, simulation.ranks), (WORLD.rank, WORLD.size))
        simulation.steps(10, 0.001)
        self.assertEqual(WORLD.allreduce(simulation.owned_nodes), 57)
        whole = np.zeros((57, 2))
        own = slice(simulation.owned_nodes)
        whole[simulation.mesh_nodes[own]] = simulation.u[own]
        whole = WORLD.allreduce(whole)
        alone = ixos.Scene(BALL).simulation(comm=MPI.COMM_SELF)
        alone.steps(10, 0.001)
        expected = np.zeros((57, 2))
        expected[alone.mesh_nodes] = alone.u
        np.testing.assert_allclose(whole, expected, atol=1e-12)

    def test_each_rank_may_have_its_own(self):
        comm = WORLD.Split(WORLD.rank)
        scene = ixos.Scene(BALL)
        scene.materials.Ball.density = 5e-7 * (1 + WORLD.rank)
        simulation = scene.simulation(comm)
        del comm  # the simulation keeps it
        self.assertEqual(simulation.ranks, 1)
        simulation.steps(5, 0.001)
        speeds = WORLD.allgather(abs(simulation.v).max())
        self.assertEqual(len(set(speeds)), WORLD.size)

    def test_refusals_reach_all_ranks(self):
        scene = ixos.Scene(BALL)
        scene.interactions.Wall.side_set = "surfase"
        with self.assertRaisesRegex(ixos.InputError, "did you mean \"surface\""):
            scene.simulation(WORLD)
        with self.assertRaisesRegex(TypeError, "is not a communicator of mpi4py"):
            ixos.Scene(BALL).simulation(comm=3)

    def test_an_exception_on_one_rank_ends_the_run_on_all(self):
        def stop(simulation):
            if simulation.rank == WORLD.size - 1 and simulation.time > 0.0045:
                raise KeyError("enough")

        folder = WORLD.bcast(tempfile.mkdtemp() if WORLD.rank == 0 else None)
        scene = ixos.Scene(BALL).set("Output/Fields Interval=0")
        if WORLD.rank == WORLD.size - 1:
            with self.assertRaisesRegex(KeyError, "enough"):
                scene.run(folder, observer=stop)
        else:
            self.assertEqual(scene.run(folder, observer=stop).status, "interrupted")
        self.assertEqual(ixos.results(folder).summary["steps"], 5)
        WORLD.Barrier()
        if WORLD.rank == 0:
            shutil.rmtree(folder)

    def test_the_repaired_solver_is_in_force(self):
        library = ixos._core.klu2_library()
        self.assertTrue(library == "" or library.startswith("libixos"), library)  # empty: nothing to repair


kept = [ixos.Scene(BALL).simulation() for _ in range(4)]  # alive when the interpreter ends

if __name__ == "__main__":
    main()
