#!/usr/bin/python3
"""Meshes from arrays."""

import numpy as np
from support import BALL, MINE, FolderTest, ixos, main, pulled_block

POINTS = np.array([[0, 0], [2, 0], [4, 0], [0, 2], [2, 2], [4, 2]], float)
CELLS = np.array([[0, 1, 4, 3], [1, 2, 5, 4]])


def block(**changes):
    """A block of 4 x 2 L0 with the sets of the scene pulled_block()."""
    arrays = {"points": POINTS, "blocks": {"body": CELLS}, "side_sets": {"lower": [[0, 1], [2, 1]]},
              "node_sets": {"left": [0, 3], "right": [2, 5], "bottom": [0, 1, 2]}}
    return ixos.Mesh(**{**arrays, **changes})


class MeshTest(FolderTest):
    def test_arrays_come_back(self):
        mesh = block()
        np.testing.assert_array_equal(mesh.points, POINTS)
        np.testing.assert_array_equal(mesh.blocks["body"], CELLS)
        np.testing.assert_array_equal(mesh.node_sets["right"], [2, 5])
        self.assertEqual([set(side) for side in mesh.side_sets["lower"]], [{0, 1}, {1, 2}])
        self.assertEqual({frozenset(side) for side in mesh.boundary},
                         {frozenset(side) for side in [(0, 1), (1, 2), (2, 5), (5, 4), (4, 3), (3, 0)]})
        self.assertFalse(mesh.points.flags.owndata)

    def test_ties_come_back_and_bear(self):
        scene = pulled_block()
        scene.set("Mesh/Refine/Corner/Upper={0.1, 0.1}")
        mesh = scene.mesh_arrays()
        self.assertEqual(sorted(len(weights) for weights in mesh.ties.values()), [2, 2])
        for node, weights in mesh.ties.items():
            place = sum(weight * mesh.points[master] for master, weight in weights.items())
            np.testing.assert_allclose(place, mesh.points[node], atol=1e-14)
        again = ixos.Mesh(mesh.points, mesh.blocks, mesh.node_sets, mesh.side_sets, mesh.ties)
        self.assertEqual(again.ties, mesh.ties)
        both = ixos.Mesh.joined({"one": mesh, "two": again})
        self.assertEqual(len(both.ties), 4)
        with self.assertRaisesRegex(ixos.InputError, "merge the parts before they are tied"):
            ixos.Mesh.joined({"one": mesh, "two": again}, merge=1e-6)
        with self.assertWarnsRegex(UserWarning, "2 of the mesh's nodes follow others"):
            mesh.write(self.folder / "mesh.e")
        plain = pulled_block()
        simulation = plain.simulation(mesh=again)
        while simulation.time < 1 - 1e-12:
            self.assertTrue(simulation.step())
        np.testing.assert_allclose(simulation.reaction("right"), [8 * 0.04 / 4 * 2, 0], atol=1e-12)

    def test_a_tied_mesh_gets_no_further_nodes(self):
        tied = pulled_block().set("Mesh/Refine/Corner/Upper={0.1, 0.1}").mesh_arrays()
        with self.assertRaisesRegex(ixos.InputError, "Mesh/Cell Order: .* the mesh has tied nodes already"):
            pulled_block().set("Mesh/Cell Order=2").simulation(mesh=tied)

    def test_the_nodes_of_a_side_set_are_points_of_the_body(self):
        scene = pulled_block().set("Interactions/Wall/Side Set=lower", "Interactions/Wall/Contact Element=Q1CH")
        simulation = scene.simulation(mesh=block(points=POINTS + [0, 1]))
        self.assertGreater(len(simulation.points), len(POINTS))
        np.testing.assert_array_equal(sorted(simulation.mesh_nodes[simulation.node_set("lower")]), [0, 1, 2])

    def test_ties_that_do_not_fit_are_refused(self):
        for ties, words in (({9: {0: 1.0}}, "ties: node 9: the points are numbered"),
                            ({1: {9: 1.0}}, "ties: node 1 follows node 9"),
                            ({1: {0: 0.5, 2: 0.4}}, "weights sum to 0.9; the sum must be 1"),
                            ({0: {1: 1.0}, 1: {0: 1.0}}, "follows itself"),
                            ({4.5: {1: 1.0}}, "a dictionary"), ({4: [1, 2]}, "a dictionary")):
            with self.subTest(words), self.assertRaisesRegex(ixos.InputError, words):
                block(ties=ties)

    def test_a_body_of_arrays_bears_its_load(self):
        simulation = pulled_block().simulation(mesh=block())
        np.testing.assert_array_equal(simulation.mesh_nodes[simulation.node_set("right")], [2, 5])
        np.testing.assert_array_equal(sorted(simulation.mesh_nodes[simulation.node_set("lower")]), [0, 1, 2])
        while simulation.time < 1 - 1e-12:
            self.assertTrue(simulation.step())
        np.testing.assert_allclose(simulation.reaction("right"), [8 * 0.04 / 4 * 2, 0], atol=1e-12)
        self.assertEqual(simulation.parameters.mesh.type, "Given")

    def test_the_ball_of_arrays_is_the_ball(self):
        for order in (1, 2):
            scene = ixos.Scene(BALL)
            scene.mesh.cell_order = order
            mesh = scene.mesh_arrays()
            self.assertEqual(mesh.blocks["body"].shape[1], 4 if order == 1 else 9)
            generated, given = scene.simulation(), scene.simulation(mesh=mesh)
            for _ in range(20):
                generated.step()
                given.step()
            np.testing.assert_array_equal(generated.u, given.u)

    def test_runs_resume_with_their_mesh_only(self):
        scene, folder = pulled_block(), self.folder / "run"
        whole = scene.run(folder, mesh=block(), comm=MINE)
        self.assertEqual(whole.steps, 4)
        again = scene.run(folder, mesh=block(), comm=MINE, restart=whole.checkpoint)
        self.assertEqual((again.status, again.steps), ("completed", 4))
        other = ixos.Mesh(POINTS * [1, 0.5], {"body": CELLS}, block().node_sets)
        with self.assertRaisesRegex(ixos.InputError, "mesh"):
            scene.run(folder, mesh=other, comm=MINE, restart=whole.checkpoint)

    def test_sets_of_the_scene_are_added(self):
        scene = pulled_block()
        scene.mesh.sets["half"] = {"Kind": "Nodes", "Upper": [2, 2]}
        simulation = scene.simulation(mesh=block())
        own = [node for node in simulation.node_set("half") if node < simulation.owned_nodes]
        self.assertLessEqual({int(simulation.mesh_nodes[node]) for node in own}, {0, 1, 3, 4})

    def test_hexahedra(self):
        points = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
        mesh = ixos.Mesh(points, {"cube": [range(8)]}, {}, {"top": [[4, 5, 6, 7]]})
        self.assertEqual(mesh.dimension, 3)
        self.assertEqual(len(mesh.boundary), 6)

    def test_quadratic_cells(self):
        places = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1)]
        mesh = ixos.Mesh(np.array(places, float), {"body": [range(9)]}, {"left": [0, 3, 7]}, {"bottom": [[0, 1]]})
        self.assertEqual(mesh.blocks["body"].shape, (1, 9))
        np.testing.assert_array_equal(mesh.side_sets["bottom"], [[0, 1]])
        self.assertEqual(len(mesh.boundary), 4)
        mesh.write(self.folder / "quadratic.e")
        np.testing.assert_array_equal(ixos.Mesh.read(self.folder / "quadratic.e").blocks["body"], [range(9)])

    def test_files(self):
        mesh = block()
        mesh.write(self.folder / "mesh.e")
        back = ixos.Mesh.read(self.folder / "mesh.e")
        np.testing.assert_array_equal(back.points, POINTS)
        np.testing.assert_array_equal(back.blocks["body"], CELLS)
        np.testing.assert_array_equal(back.node_sets["left"], [0, 3])
        changed = block(points=2 * POINTS)
        with self.assertRaisesRegex(ixos.InputError, r"mesh\.e exists; choose another name, or replace"):
            changed.write(self.folder / "mesh.e")
        np.testing.assert_array_equal(ixos.Mesh.read(self.folder / "mesh.e").points, POINTS)
        changed.write(self.folder / "mesh.e", overwrite=True)
        np.testing.assert_array_equal(ixos.Mesh.read(self.folder / "mesh.e").points, 2 * POINTS)

    def test_bad_arrays_are_refused(self):
        for words, changes in (
                ("points: the array has 1 dimensions", {"points": POINTS[0]}),
                ("points: they have 1 coordinates; 2 or 3 are allowed", {"points": POINTS[:, :1]}),
                ("points: an array of numbers is needed", {"points": [[0, 0], [1]]}),
                ("points: an array of numbers is needed", {"points": POINTS.astype(complex)}),
                ("points: an array of numbers is needed", {"points": "ab"}),
                ("point 0 has the coordinate nan", {"points": np.where(POINTS == 0, np.nan, POINTS)}),
                ("point 6 belongs to no cell", {"points": np.vstack([POINTS, [[9, 9]]])}),
                ('block "body" has node 6; the points are numbered from 0 to 5', {"blocks": {"body": CELLS + 1}}),
                ('block "body": its cells have 2 nodes', {"blocks": {"body": CELLS[:, :2]}}),
                ('block "body": an array of integers', {"blocks": {"body": CELLS + 0.5}}),
                ("no blocks", {"blocks": {}, "node_sets": {}, "side_sets": {}}),
                ('block "body", cell 1 at (1, 1): inverted', {"blocks": {"body": CELLS[:, ::-1]}}),
                ('node set "left" has node 9', {"node_sets": {"left": [9]}}),
                ('node set "left" has node 0 twice', {"node_sets": {"left": [0, 0]}}),
                ("a node set has an empty name", {"node_sets": {"": [0]}}),
                ('side set "in": two cells share', {"side_sets": {"in": [[1, 4]]}}),
                ('side set "in": no cell has a side with the nodes 0, 4', {"side_sets": {"in": [[0, 4]]}}),
                ('side set "in": its sides have 4 nodes', {"side_sets": {"in": [[0, 1, 2, 3]]}})):
            with self.subTest(words), self.assertRaises(ixos.InputError) as caught:
                block(**changes)
            self.assertIn(words, str(caught.exception))
        with self.assertRaisesRegex(ixos.InputError, "elements 1 and 2 have the same nodes"):
            twice = ixos.Mesh(POINTS[[0, 1, 4, 3]], {"a": [[0, 1, 2, 3]], "b": [[1, 2, 3, 0]]})
            pulled_block().simulation(mesh=twice)

    def test_a_block_may_have_cells_of_several_types(self):
        mixed = [[[0, 1, 4, 3]], [[1, 2, 5], [1, 5, 4]]]
        mesh = ixos.Mesh(POINTS, {"body": [np.array(cells) for cells in mixed]}, {"left": [0, 3]},
                         {"bottom": [[0, 1], [1, 2]]})
        self.assertEqual([cells.tolist() for cells in mesh.blocks["body"]], mixed)
        self.assertEqual(mesh.side_sets["bottom"].tolist(), [[0, 1], [1, 2]])
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [0.3, 0.3, 2]])
        prism = ixos.Mesh(points, {"body": [np.array([[0, 1, 2, 3, 4, 5]]), np.array([[3, 4, 5, 6]])]}, {},
                          {"some": [[0, 1, 4, 3], [0, 2, 1, -1]], "bottom": [[0, 2, 1]]})
        self.assertEqual(prism.side_sets["some"].tolist(), [[0, 1, 4, 3], [0, 2, 1, -1]])
        self.assertEqual(prism.side_sets["bottom"].tolist(), [[0, 2, 1]])
        with self.assertRaisesRegex(ixos.InputError, "two blocks have the name"):
            ixos.Mesh(POINTS, {"body": [CELLS[:1], CELLS[1:]]})

    def test_meshes_are_joined_under_their_names(self):
        one = block()
        joined = ixos.Mesh.joined({"left": one, "right": ixos.Mesh(POINTS + [9, 0], {"body": CELLS})})
        self.assertEqual(list(joined.blocks), ["left_body", "right_body"])
        np.testing.assert_array_equal(joined.points, np.vstack([POINTS, POINTS + [9, 0]]))
        np.testing.assert_array_equal(joined.blocks["right_body"], CELLS + len(POINTS))
        np.testing.assert_array_equal(joined.node_sets["left_left"], one.node_sets["left"])
        with self.assertRaisesRegex(ixos.InputError, "a part has an empty name"):
            ixos.Mesh.joined({"": one})

    def test_meshes_that_share_a_face_are_merged(self):
        one = block()
        width = np.ptp(POINTS[:, 0])
        apart = {"left": one, "right": ixos.Mesh(POINTS + [width, 0], {"body": CELLS})}
        shared = int(np.sum(POINTS[:, 0] == POINTS[:, 0].max()))
        self.assertEqual(len(ixos.Mesh.joined(apart, merge=1e-9).points), 2 * len(POINTS) - shared)
        with self.assertRaisesRegex(ixos.InputError, "no node of a part is within 1e-09"):
            ixos.Mesh.joined({"left": one, "right": ixos.Mesh(POINTS + [9, 0], {"body": CELLS})}, merge=1e-9)

    def test_the_command_has_no_given_mesh(self):
        scene = pulled_block()
        scene.mesh.type = "Given"
        with self.assertRaisesRegex(ixos.InputError, "a program provides this mesh"):
            scene.simulation()


if __name__ == "__main__":
    main()
