#!/usr/bin/python3
"""The fields of results as arrays, written by any number of ranks."""
import pathlib
import shutil
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np
from support import BALL, ixos, main

try:
    from mpi4py.MPI import COMM_WORLD as WORLD
except ImportError:
    WORLD = None
FIELDS = "Output/Fields={default, stress, gap}"


def same_folder():
    """Returns a new folder, the same on all ranks."""
    folder = tempfile.mkdtemp(prefix="ixos-") if WORLD is None or WORLD.rank == 0 else None
    return pathlib.Path(folder if WORLD is None else WORLD.bcast(folder))


def wait():
    """Returns when all ranks are here."""
    if WORLD is not None:
        WORLD.Barrier()


def whole(simulation, values):
    """Returns an array of all nodes of the mesh on every rank."""
    own = slice(simulation.owned_nodes)
    if simulation.ranks == 1:
        nodes, gathered = simulation.mesh_nodes, values
    else:
        nodes = np.concatenate(WORLD.allgather(simulation.mesh_nodes[own].copy()))
        gathered = np.concatenate(WORLD.allgather(values[own].copy()))
    return gathered[np.argsort(nodes)]


def areas(points, cells):
    """Returns the areas of quadrilaterals, by the shoelace formula."""
    x, y = points[cells, 0], points[cells, 1]
    return 0.5 * np.abs(np.sum(x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1), axis=1))


class FieldsTest(unittest.TestCase):
    def setUp(self):
        self.folder = same_folder()

    def tearDown(self):
        wait()
        if WORLD is None or WORLD.rank == 0:
            shutil.rmtree(self.folder)

    def run_ball(self, *settings):
        """Runs the ball with a frame every fifth step. Returns the results, and u, v and gaps at the frames."""
        seen = []

        def look(simulation):
            if round(simulation.time / 0.001) % 5 == 0:
                seen.append([whole(simulation, values) for values in (simulation.u, simulation.v, simulation.gaps)])

        scene = ixos.Scene(BALL).set("Time Integrator/Time Step Control/Final Time=0.02", "Output/Fields Interval=5",
                                     FIELDS, *settings)
        done = scene.run(self.folder / "run", observer=look)
        wait()
        return done.results, seen

    def test_nodal_fields_are_the_states(self):
        for kind in ("Exodus", "HDF5"):
            results, seen = self.run_ball(f"Output/Fields Format={kind}")
            fields = results.fields
            self.assertEqual(len(fields.times), 5)
            np.testing.assert_allclose(fields.times, results["time"][::5], rtol=0, atol=1e-15)
            self.assertEqual((fields.dimension, fields.points.shape, fields.cells.shape), (2, (57, 2), (48, 4)))
            np.testing.assert_array_equal(fields.mesh_nodes, np.arange(57))
            for name, number in (("displacement", 0), ("velocity", 1), ("gap", 2)):
                np.testing.assert_array_equal(fields[name][1:], [frame[number] for frame in seen], name)
                np.testing.assert_array_equal(fields.at(name, fields.frame(0.0101)), seen[1][number], name)
            np.testing.assert_array_equal(fields["displacementY"], fields["displacement"][..., 1])
            wait()
            if results.summary["ranks"] > 1 and kind == "Exodus":
                self.assertEqual(sorted(path.name for path in self.folder.glob("run/fields.e*")),
                                 [f"fields.e.{WORLD.size}.{rank}" for rank in range(WORLD.size)])
            wait()
            if WORLD is None or WORLD.rank == 0:
                shutil.rmtree(self.folder / "run")
            wait()

    def test_cell_fields_sum_to_the_history(self):
        results, _ = self.run_ball()
        fields = results.fields
        area = areas(fields.points, fields.cells)
        np.testing.assert_allclose(fields["energy_density"] @ area, results["elastic_energy"][::5], rtol=1e-12,
                                   atol=1e-16)
        self.assertEqual(fields["stress"].shape, (5, 48, 4))  # XX, YY, ZZ, XY
        np.testing.assert_allclose(fields["stress"][..., :3].sum(axis=-1), fields["first_stress_invariant"], atol=1e-14)
        for name, values in fields.totals.items():
            np.testing.assert_allclose(values, results[name][::5], rtol=1e-15, atol=1e-18)

    def test_the_mesh_is_the_scenes(self):
        fields = self.run_ball()[0].fields
        mesh = ixos.Scene(BALL).mesh_arrays()
        np.testing.assert_array_equal(fields.points, mesh.points)
        np.testing.assert_array_equal(fields.cells[fields.blocks["body"]], mesh.blocks["body"])
        np.testing.assert_array_equal(fields.node_sets["center"], mesh.node_sets["center"])
        self.assertEqual(set(fields), {"displacement", "velocity", "acceleration", "interaction_traction", "gap",
                                       "stress", "first_stress_invariant", "jacobian", "energy_density"})
        self.assertEqual(fields.information()["scene"], "Ball")

    def test_enriched_cells_are_blocks_of_their_own(self):
        fields = self.run_ball("Interactions/Wall/Contact Element=Q1C4")[0].fields
        self.assertEqual({name: len(cells) for name, cells in fields.blocks.items()}, {"body": 32, "body_contact": 64})
        self.assertEqual(sorted(np.concatenate(list(fields.blocks.values()))), list(range(96)))
        mesh = ixos.Scene(BALL).mesh_arrays()
        self.assertAlmostEqual(areas(fields.points, fields.cells).sum(),
                               areas(mesh.points, mesh.blocks["body"]).sum(), places=9)

    def test_what_is_not_there_is_refused(self):
        results, _ = self.run_ball()
        fields = results.fields
        for call, words in ((lambda: fields["stres"], "has no field 'stres'; it has acceleration, displacement"),
                            (lambda: fields.frame(7), "has no frame near time 7: its 5 frames go from 0 to 0.02")):
            with self.assertRaises(ixos.FileError) as caught:
                call()
            self.assertIn(words, str(caught.exception))
        with mock.patch.dict(sys.modules, netCDF4=None), self.assertRaisesRegex(ixos.FileError, "python3-netcdf4"):
            ixos.Fields(results.folder)
        wait()
        if WORLD is None or WORLD.rank == 0:
            files = sorted(self.folder.glob("run/fields.e*"))
            files[-1].write_bytes(b"CDF\x02" + bytes(100))
            with self.assertRaisesRegex(ixos.FileError, "not an Exodus file"):
                ixos.Fields(results.folder)
            files[-1].unlink()
            with self.assertRaisesRegex(ixos.FileError, "fields.e"):
                ixos.Fields(results.folder)


if __name__ == "__main__":
    main()
