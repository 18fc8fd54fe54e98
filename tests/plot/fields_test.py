#!/usr/bin/python3
"""Tests of the fields of fields.e, also as VTK reads them: IXOS_DRIVER=.../ixos IXOS_XML=.../xml tests/plot/fields_test.py"""
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True
from scripts import ScriptTest, simulate  # noqa: E402 (sets the path to the others)
import result_files  # noqa: E402
from exodus import Fields  # noqa: E402
from results import ResultsError, Run  # noqa: E402

from vtkmodules.vtkCommonCore import mutable  # noqa: E402
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline  # noqa: E402
from vtkmodules.vtkIOExodus import vtkExodusIIReader  # noqa: E402

try:
    from vtkmodules.vtkIOIOSS import vtkIOSSReader
except ImportError:
    vtkIOSSReader = None

LISTED = ("Output/Fields={default, gap, contact_pressure, reaction, stress, von_mises_stress, principal_stress, gap_Wall, "
          "normal_Wall, traction_Wall, pressure_Wall}")
# A strip that is pulled off a wall, its right edge prescribed: 81 x 3 nodes, 40 of 80 sides before the wall.
STRIP = ["Mesh/Box/Divisions={80, 2}", "Mesh/Sets/contact/Upper={100, 1}", "Interactions/Wall/Contact Element=Q1C1",
         "Time Integrator/Type=Static", "Time Integrator/Time Step Control/Time Step=1", "Histories/Pull/Rate Ramp/Length=4",
         "Time Integrator/Time Step Control/Final Time=4", "Output/Fields Time Interval=2",
         "Output/Interaction Columns=On", LISTED]
CUBE = ["Mesh/Type=Box", "Mesh/Box/Dimension=3", "Mesh/Box/Lower={-1,-1,1}", "Mesh/Box/Lengths={2,2,2}",
        "Mesh/Box/Divisions={2,2,2}", "Interactions/Wall/Side Set=bottom",
        "Time Integrator/Time Step Control/Final Time=0.003", "Output/Fields Interval=3"]

# Two squares above a wall. The block, the side set and its node set are called base; another node set base_nodes.
SQUARES = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
4
0 1 "corner"
0 2 "base_nodes"
1 1 "base"
2 1 "base"
$EndPhysicalNames
$Entities
2 1 1 0
1 0 8 0 1 1
2 1 8 0 1 2
1 0 8 0 2 8 0 1 1 0
1 0 8 0 2 9 0 1 1 0
$EndEntities
$Nodes
1 6 1 6
2 1 0 6
1
2
3
4
5
6
0 8 0
1 8 0
2 8 0
0 9 0
1 9 0
2 9 0
$EndNodes
$Elements
4 6 1 6
0 1 15 1
1 1
0 2 15 1
2 2
1 1 1 2
3 1 2
4 2 3
2 1 3 2
5 1 2 5 4
6 2 3 6 5
$EndElements
"""


class FieldsTest(ScriptTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.strips = []
        for ranks, form in ((1, "Exodus"), (2, "Exodus"), (2, "HDF5")):
            folder = cls.folder / f"strip-{ranks}-{form}"
            simulate(folder, [*STRIP, f"Output/Fields Format={form}"], ranks, "strip.xml")
            cls.strips.append((Fields(folder), Run(folder)))

    def test_reactions_of_a_set_sum_to_the_column(self):
        for fields, run in self.strips:
            edge = fields.coordinates[:, 0] == fields.coordinates[:, 0].max()
            self.assertEqual(np.count_nonzero(edge), 3)
            for frame, row in enumerate((0, 2, 4)):
                reaction = fields.nodal("reaction", frame)
                self.assertEqual(np.abs(reaction[~edge]).max(), 0.0)
                for i, axis in enumerate("xy"):
                    self.assertAlmostEqual(reaction[edge, i].sum(), run[f"reaction_right_{axis}"][row], delta=1e-15)
            self.assertGreater(abs(run["reaction_right_y"][4]), 1e-6)

    def test_pressure_times_area_is_the_force_of_the_wall(self):
        for fields, run in self.strips:
            for frame, row in enumerate((0, 2, 4)):
                gap, pressure = fields.nodal("gap", frame), fields.nodal("contact_pressure", frame)
                surface = np.flatnonzero(~np.isnan(gap))
                self.assertEqual(len(surface), 41)
                place = fields.coordinates[surface]
                np.testing.assert_allclose(gap[surface], place[:, 1] + fields.displacement(frame)[surface, 1], atol=1e-7)
                area = np.zeros(len(gap))
                line = surface[np.argsort(place[:, 0])]
                lengths = np.diff(fields.coordinates[line, 0])
                area[line[1:]] += lengths / 2
                area[line[:-1]] += lengths / 2
                self.assertAlmostEqual(pressure @ area, run["contact_force_y"][row], delta=1e-13)
                deformed = fields.coordinates[:, 0] + fields.displacement(frame)[:, 0]
                moment = run["contact_moment_Wall_z"][row]  # x F_y
                self.assertAlmostEqual(deformed @ (pressure * area), moment, delta=1e-7 * max(1, abs(moment)))
                np.testing.assert_allclose(pressure, fields.nodal("interaction_traction", frame)[:, 1], atol=1e-14)
                self.assertEqual(np.abs(np.delete(pressure, surface)).max(), 0.0)

    def test_the_only_interaction_has_the_fields_and_columns_of_all(self):
        for fields, run in self.strips:
            for frame in range(len(fields.times)):
                for own, of_all in (("gap_Wall", "gap"), ("pressure_Wall", "contact_pressure"),
                                    ("traction_Wall", "interaction_traction")):
                    np.testing.assert_array_equal(fields.nodal(own, frame), fields.nodal(of_all, frame))
                surface = ~np.isnan(fields.nodal("gap", frame))
                np.testing.assert_array_equal(fields.nodal("normal_Wall", frame), np.outer(surface, [0, 1]))
            for own, of_all in (("contact_force_Wall_x", "contact_force_x"), ("contact_force_Wall_y", "contact_force_y"),
                                ("contact_measure_Wall", "contact_measure"), ("min_gap_Wall", "min_gap")):
                np.testing.assert_array_equal(run[own], run[of_all])

    def test_stresses_agree_with_each_other(self):
        for fields, _ in self.strips:
            for frame in (1, 2):
                xx, yy, zz, xy = (fields.element("stress" + ending, frame) for ending in ("XX", "YY", "ZZ", "XY"))
                np.testing.assert_allclose(xx + yy + zz, fields.element("first_stress_invariant", frame), atol=1e-14)
                tensors = np.zeros((len(xx), 3, 3))
                tensors[:, 0, 0], tensors[:, 1, 1], tensors[:, 2, 2] = xx, yy, zz
                tensors[:, 0, 1] = tensors[:, 1, 0] = xy
                principal = np.linalg.eigvalsh(tensors)[:, ::-1]
                for i in range(3):
                    np.testing.assert_allclose(fields.element(f"principal_stress{i + 1}", frame), principal[:, i], atol=1e-14)
                mises = np.sqrt(0.5 * sum((principal[:, i] - principal[:, i - 1]) ** 2 for i in range(3)))
                np.testing.assert_allclose(fields.element("von_mises_stress", frame), mises, atol=1e-14)
                self.assertGreater(mises.max(), 1e-4)

    def test_two_ranks_write_the_fields_of_one(self):
        one = self.strips[0][0]
        for other, _ in self.strips[1:]:
            for frame in range(len(one.times)):
                for name in ("gap", "contact_pressure", "reaction"):
                    np.testing.assert_allclose(other.nodal(name, frame), one.nodal(name, frame), atol=1e-9)
                for name in ("stressXX", "stressXY", "von_mises_stress"):
                    np.testing.assert_allclose(other.element(name, frame), one.element(name, frame), atol=1e-9)

    def test_the_records_tell_scene_and_units(self):
        records = [fields.information() for fields, _ in self.strips]
        for record in records:
            self.assertTrue(record["written by"].startswith("Ixos "))
            self.assertEqual(record["scene"], "Strip")
            self.assertTrue(record["scene file"].endswith("strip.xml"))
            self.assertEqual((record["unit of reaction"], record["unit of total_energy"]), ("E0 L0", "E0 L0^2"))
            self.assertEqual(record["unit of von_mises_stress"], "E0")
            self.assertEqual((record["L0"], record["T0"]), ("1 nm", "1 ns"))
            self.assertEqual(len(record["digest of the scene"]), 32)
        self.assertEqual(records[0], records[1])
        self.assertEqual(records[0], records[2])

    def test_vtk_joins_components_to_names_without_underscore(self):
        reader = vtkExodusIIReader()
        reader.SetFileName(str(self.strips[0][0].path))
        reader.UpdateInformation()
        reader.SetAllArrayStatus(reader.NODAL, 1)
        vectors = {reader.GetPointResultArrayName(i) for i in range(reader.GetNumberOfPointResultArrays())}
        self.assertEqual(vectors, {"displacement", "velocity", "acceleration", "interaction_traction", "gap",
                                   "contact_pressure", "reaction", "gap_Wall", "normal_Wall", "traction_Wall",
                                   "pressure_Wall"})

    def test_a_cell_has_the_mean_of_its_nodes(self):
        fields, _ = self.strips[0]
        mean = np.array([np.linalg.norm(fields.nodal("displacement", 2)[cell], axis=1).mean() for cell in fields.cells])
        np.testing.assert_allclose(fields.element("displacement", 2), mean, rtol=1e-14)
        mean = np.array([fields.nodal("displacement", 2)[cell, 1].mean() for cell in fields.cells])
        np.testing.assert_allclose(fields.element("displacementY", 2), mean, rtol=1e-14, atol=1e-18)
        with self.assertRaisesRegex(ResultsError, "choose one: stressXX, stressYY, stressZZ, stressXY"):
            fields.element("stress", 2)

    def test_frames_of_stages_with_other_fields_follow(self):
        folder = self.folder / "stages"
        simulate(folder, ["Output/Fields Time Interval=2", "Stages/Pull/Output/Fields={displacement, gap}"],
                 scene="press-wait-pull.xml")
        fields = result_files.Fields(folder)
        run = Run(folder)
        self.assertTrue((folder / "fields-2.e").is_file())
        pressed, waited = (stage["end_time"] for stage in run.summary["stages"][:2])
        self.assertEqual((fields.times[0], fields.times[-1]), (0, run["time"][-1]))
        last = np.count_nonzero(fields.times > waited) + 1  # fields.e ends and fields-2.e begins there
        late, early = np.isnan(fields["velocity"]).all(axis=(1, 2)), np.isnan(fields["gap"]).all(axis=1)
        self.assertEqual((list(np.flatnonzero(~late)), list(np.flatnonzero(~early))),
                         (list(range(len(late) - last)), list(range(len(late) - last, len(late)))))
        self.assertEqual(list(fields.frames_with("gap")), list(np.flatnonzero(~early)))
        with_gap = Fields(folder, "gap")
        np.testing.assert_array_equal(with_gap.times, fields.times[~early])
        np.testing.assert_array_equal(with_gap.nodal("gap", 0), fields.at("gap", len(late) - last))
        np.testing.assert_array_equal(fields.at("gap", slice(-3, None)), fields["gap"][-3:])
        for frame in (0, 3, -1):
            np.testing.assert_array_equal(fields.at("displacement", frame), fields["displacement"][frame])
        head = fields.nodes("top")
        np.testing.assert_allclose(fields.at("displacement", -1)[head, 1], 6 - 0.3 * pressed, rtol=1e-6)
        (folder / "fields-2.e").write_bytes(b"CDF")
        with self.assertRaisesRegex(result_files.FileError, "fields-2.e is not an Exodus file"):
            result_files.Fields(folder)
        (folder / "summary.json").unlink()  # killed while it wrote
        self.assertEqual(len(result_files.Fields(folder).times), len(late) - last)

    def test_a_mesh_that_follows_the_front_has_files_of_its_own(self):
        folder = self.folder / "follows"
        simulate(folder, ["Mesh/Type=Box", "Mesh/Box/Lengths={200, 10}", "Mesh/Box/Lower={0, 0.254709287789268}",
                          "Mesh/Box/Divisions={40, 2}", "Mesh/Adapt/Levels=2", "Output/Fields Interval=10",
                          "Output/Fields Time Interval=0", "Time Integrator/Time Step Control/Final Time=20",
                          "Time Integrator/Type=Average Vector Field"], scene="strip.xml")
        run, meshes = Run(folder), result_files.Fields.meshes(folder)
        self.assertGreater(len(meshes), 1)
        self.assertEqual(len(meshes), len(list(folder.glob("fields.e*"))))
        self.assertEqual(run.summary["elements"], sum(len(pieces) for pieces in meshes[-1].blocks.values()) -
                         3 * sum(len(pieces) for name, pieces in meshes[-1].blocks.items() if "contact" in name) // 4)
        self.assertGreater(len(meshes[-1].points), len(meshes[0].points))
        times = np.concatenate([fields.times for fields in meshes])
        np.testing.assert_allclose(times, np.arange(21), atol=1e-12)
        total = np.concatenate([fields.totals["total_energy"] for fields in meshes])
        np.testing.assert_array_equal(total, run["total_energy"][np.searchsorted(run["time"], times - 1e-9)])
        self.assertLess(run.energy_error().max(), 1e-11)
        self.assertGreater(abs(run["adapted_energy"][-1]), 1e-9)
        drawn = Fields(folder, "first_stress_invariant")  # the scripts' own
        np.testing.assert_array_equal(drawn.times, times)
        for frame in (0, -1):
            cells = meshes[frame].cells.shape[0]
            self.assertEqual(len(drawn.element("first_stress_invariant", frame)), cells)
            self.assertEqual(len(drawn.polygons(frame)), len(drawn.of_wholes(np.zeros(cells), frame)))
            np.testing.assert_allclose(drawn.positions(frame),
                                       meshes[frame].points + meshes[frame].at("displacement", frame))
        if vtkIOSSReader is not None:  # ParaView's reader finds the series by the first name
            reader = vtkIOSSReader()
            reader.AddFileName(str(folder / "fields.e"))
            reader.UpdateInformation()
            found = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
            np.testing.assert_allclose(found, times, atol=1e-12)
            for frame in (0, -1):
                reader.UpdateTimeStep(found[frame])
                # A block has its own copies of the nodes that it shares, and side sets do, too.
                self.assertGreaterEqual(reader.GetOutputDataObject(0).GetNumberOfPoints(), len(meshes[frame].points))

    @unittest.skipIf(vtkIOSSReader is None, "VTK without its IOSS reader")
    def test_the_reader_on_ioss_joins_tensors_too(self):
        simulate(self.folder / "cube", [*CUBE, "Output/Fields={displacement, stress, principal_stress}"])
        for path, name in ((self.folder / "cube" / "fields.e", "cube"), (self.strips[0][0].path, "strip")):
            reader = vtkIOSSReader()
            reader.AddFileName(str(path))
            reader.UpdateInformation()
            cells, nodes = reader.GetElementBlockFieldSelection(), reader.GetNodeBlockFieldSelection()
            names = {cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())}
            self.assertIn("stress", names, name)
            joined, parts = {"principal_stress"}, {f"principal_stress{i}" for i in (1, 2, 3)}  # as VTK's version has it
            self.assertTrue(joined <= names or parts <= names, f"{name}: {names}")
            self.assertIn("displacement", {nodes.GetArrayName(i) for i in range(nodes.GetNumberOfArrays())}, name)

    def test_vtk_sees_the_shape_of_quadratic_cells(self):
        """The map is of second order in each direction, as VTK's cells are: what it moves is the same everywhere."""
        flat = [*CUBE, "Mesh/Box/Dimension=2", "Mesh/Box/Lower={-1,1}", "Mesh/Box/Lengths={2,2}", "Mesh/Box/Divisions={2,2}"]
        for name, settings, lifted, kind in (("bricks", CUBE, "Z=z + 0.1*x^2*(1 + y)^2", 29),
                                             ("plates", flat, "Y=y + 0.1*x^2", 28)):
            simulate(self.folder / name, [*settings, "Mesh/Cell Order=2", f"Mesh/Map/{lifted}"])
            reader = vtkExodusIIReader()
            reader.SetFileName(str(self.folder / name / "fields.e"))
            reader.Update()
            grid = reader.GetOutput().GetBlock(0).GetBlock(0)
            self.assertEqual(grid.GetNumberOfCells(), 8 if kind == 29 else 4)
            for number in range(grid.GetNumberOfCells()):
                cell = grid.GetCell(number)
                self.assertEqual(cell.GetCellType(), kind)
                for place in np.random.default_rng(1).random((5, 3)):
                    weights = np.zeros(cell.GetNumberOfPoints())
                    x = np.zeros(3)
                    cell.EvaluateLocation(mutable(0), place, x, weights)
                    up = 2 if kind == 29 else 1
                    bend = 0.1 * x[0] ** 2 * ((1 + x[1]) ** 2 if kind == 29 else 1)
                    low = np.array(cell.GetPoints().GetPoint(0))
                    low[up] -= 0.1 * low[0] ** 2 * ((1 + low[1]) ** 2 if kind == 29 else 1)
                    x[up] -= bend
                    np.testing.assert_allclose(x[:up + 1], (low + place)[:up + 1], atol=1e-6)

    @unittest.skipIf(vtkIOSSReader is None, "VTK without its IOSS reader")
    def test_the_reader_on_ioss_finds_blocks_and_sets_of_equal_names(self):
        mesh = self.folder / "squares.msh"
        mesh.write_text(SQUARES)
        settings = ["Mesh/Type=Gmsh", f"Mesh/Gmsh/File={mesh}", "Materials/Ball/Block=base",
                    "Interactions/Wall/Side Set=base", "Time Integrator/Time Step Control/Final Time=0.003"]
        simulate(self.folder / "squares", [*settings, "Output/Fields Interval=3"])
        reader = vtkIOSSReader()
        reader.AddFileName(str(self.folder / "squares" / "fields.e"))
        reader.UpdateInformation()
        found = []
        for chosen in (reader.GetElementBlockSelection(), reader.GetSideSetSelection(), reader.GetNodeSetSelection()):
            found.append({chosen.GetArrayName(i) for i in range(chosen.GetNumberOfArrays())})
        self.assertEqual(found, [{"base"}, {"base_sides"}, {"corner", "base_nodes", "base_nodes_2"}])


if __name__ == "__main__":
    outcome = unittest.main(exit=False).result
    sys.exit(1 if not outcome.wasSuccessful() else 77 if outcome.skipped else 0)  # 77: some were skipped
