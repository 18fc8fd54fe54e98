"""The frames of a results folder in the units of the axes, and the outlines of its cells."""
import numpy as np

import result_files
import units
from scene_file import ResultsError, existing, find, is_axisymmetric, read_scene

# Pieces of a plane cell's side by contact element: fields.e has a cell for each.
PIECES = {"Q1C2": 2, "Q1C3": 3, "Q1C4": 4, "Q1CH": 4, "Q2C4": 2}


class Fields:
    """The fields over time, in the units of the axes. Frames of stages without displacement, or without a needed field,
    are left out.

    times: time of each frame; dimension: 2 or 3; coordinates, cells and wholes: of the mesh of the first frame, see
    FieldsOnMesh. A mesh that follows the front changes from frame to frame: on_mesh(frame) is that of a frame."""

    def __init__(self, folder, *needed):
        files = result_files.Fields.meshes(existing(folder))
        self.path = files[0].path
        if not sum(len(file.times) for file in files):
            raise ResultsError(f"{self.path} has no frames")
        if "displacement" in files[0]:
            needed = "displacement", *needed
        self._meshes = [mesh for mesh in (FieldsOnMesh(file, folder, needed) for file in files) if len(mesh.times)]
        if not self._meshes:
            for name in needed:
                files[0].frames_with(name)  # which tells what fields there are
            raise ResultsError(f"{self.path}: no stage has all of {', '.join(needed)}")
        self.times = np.concatenate([mesh.times for mesh in self._meshes])
        first = self._meshes[0]
        self.dimension, self.coordinates, self.cells, self.wholes = (first.dimension, first.coordinates, first.cells,
                                                                     first.wholes)
        self.nodal_names, self.nodes_of, self.information = first.nodal_names, first.nodes_of, first.information

    def on_mesh(self, frame):
        """The fields on a frame's mesh, and the frame's number there."""
        frame = range(len(self.times))[frame]
        for mesh in self._meshes:
            if frame < len(mesh.times):
                break
            frame -= len(mesh.times)
        return mesh, frame

    def _at(self, frame, function, *arguments):
        mesh, frame = self.on_mesh(frame)
        return getattr(mesh, function)(*arguments, frame)

    def nodal(self, name, frame):
        """A nodal vector (displacement, velocity, ..., reaction): a row a node; of a scalar (gap) a value a node."""
        return self._at(frame, "nodal", name)

    def nodal_components(self, name, frame):
        """A field of nodes in the units of the axes: arrays by the names of its components, or of the field."""
        return self._at(frame, "nodal_components", name)

    def displacement(self, frame):
        """Displacements: a row a node."""
        return self._at(frame, "displacement")

    def positions(self, frame):
        """Deformed places: a row a node."""
        return self._at(frame, "positions")

    def element(self, name, frame):
        """A value a cell: of a field of cells, or the mean of a field of nodes over the cell's nodes; of a vector its
        magnitude. A component has a name of its own, such as stressXY and displacementX."""
        return self._at(frame, "element", name)

    def of_wholes(self, values, frame=0):
        """Values of cells, a value for each whole cell: its pieces have the same."""
        return self.on_mesh(frame)[0].of_wholes(values)

    def node_set(self, name, frame):
        """Deformed places of the nodes of a set, a row a node; none where no file has nodes of it."""
        return self._at(frame, "node_set", name)

    def total(self, name, frame):
        """A global variable, such as total_energy, at a frame."""
        return self._at(frame, "total", name)

    def polygons(self, frame):
        """Outlines of the whole cells of a plane body, deformed: an array (corners, 2) a cell."""
        return self._at(frame, "polygons")

    def nearest_frame(self, time):
        """The frame at a time, at most half a frame's interval away."""
        return result_files.nearest_frame(self.path, self.times, time)


class FieldsOnMesh:
    """A mesh and its fields over time, numbered as the whole mesh is, whatever the number of ranks.

    coordinates: a row a node; cells: the nodes of each cell, a row a cell; wholes: for each cell of the scene's mesh its
    pieces in the file, more than one where a plane cell's side is enriched. Functions are those of Fields."""

    def __init__(self, file, folder, needed):
        self._file = file
        self.path, self.dimension, self.cells = file.path, file.dimension, file.cells
        self._frames = np.arange(len(file.times))  # by number here: that in the file
        for name in needed:
            try:
                self._frames = np.intersect1d(self._frames, file.frames_with(name))
            except result_files.FileError:  # no frame on this mesh has it
                self._frames = self._frames[:0]
        self._scales = units.scales(folder)
        self._body_dimension = 3 if is_axisymmetric(folder) else self.dimension
        self.times = self._file.times[self._frames] * self._factor("time")
        self.coordinates = self._file.points * self._factor("length")
        self.wholes = self._join_pieces()

    def _factor(self, quantity):
        return units.factor(self._scales, quantity, self._body_dimension) if quantity else 1.0

    def _join_pieces(self):
        """The cells of the file by cell of the scene's mesh: pieces have consecutive numbers in their block."""
        pieces = pieces_of_sides(self.path.parent) if self.dimension == 2 else 1
        wholes = []
        blocks = {name: cells for name, cells in self._file.blocks.items() if len(cells)}
        for name, cells in sorted(blocks.items(), key=lambda item: item[1][0]):
            size = pieces if "_contact" in name and len(cells) % pieces == 0 else 1
            wholes += list(cells.reshape(-1, size))
        return wholes

    def nodal(self, name, frame):
        return self._file.at(name, self._frames[frame])

    def nodal_names(self):
        """The names of the fields of nodes."""
        return [name for name in self._file if self._file.is_nodal(name)]

    def nodal_components(self, name, frame):
        if not self._file.is_nodal(name):
            raise ResultsError(f"{self.path}: '{name}' is a field of cells; fields of nodes: {', '.join(self.nodal_names())}")
        values = self.nodal(name, frame) * self._factor(units.field_quantity(name))
        if values.ndim == 1:
            return {name: values}
        return {name + axis: column for axis, column in zip("XYZ", values.T)}

    def nodes_of(self, name):
        """The nodes of a node set or a side set."""
        return self._file.nodes(name)

    def displacement(self, frame):
        return self.nodal("displacement", frame) * self._factor("length")

    def positions(self, frame):
        return self.coordinates + self.displacement(frame)

    def element(self, name, frame):
        nodal = self._file.is_nodal(name)
        values = self._file.at(name, self._frames[frame])
        if nodal and values.ndim > 1:
            values = np.linalg.norm(values, axis=1)
        if values.ndim > 1:
            numbers = self._file.components(name)
            raise ResultsError(f"{self.path}: '{name}' has several numbers a cell; choose one: {', '.join(numbers)}")
        if nodal:
            there = self.cells >= 0
            values = np.where(there, values[self.cells], 0).sum(axis=1) / there.sum(axis=1)
        return values * self._factor(units.field_quantity(name))

    def of_wholes(self, values):
        return values[[whole[0] for whole in self.wholes]]

    def node_set(self, name, frame):
        """Deformed places of the nodes of a set. A node set with the name of a side set is called name_nodes in the
        file."""
        sets = self._file.node_sets
        nodes = sets.get(name, sets.get(name + "_nodes", np.zeros(0, int)))
        return self.positions(frame)[nodes]

    def information(self):
        """The file's records by key: scene, units, what wrote it."""
        return self._file.information()

    def total(self, name, frame):
        if name not in self._file.totals:
            raise ResultsError(f"{self.path} has no global variable '{name}'")
        return float(self._file.totals[name][self._frames[frame]]) * self._factor("energy")

    def polygons(self, frame):
        if self.dimension != 2:
            raise ResultsError(f"{self.path}: the body is not plane")
        positions = self.positions(frame)
        return [positions[self._outline(whole)] for whole in self.wholes]

    def _outline(self, whole):
        """The nodes around a whole cell. The first side of its pieces is the enriched one, the third its opposite."""
        cells = self.cells[whole]
        cells = cells[:, :np.count_nonzero(cells[0] >= 0)]
        if cells.shape[1] in (3, 6):
            return cells[0][[0, 1, 2] if cells.shape[1] == 3 else [0, 3, 1, 4, 2, 5]]
        if cells.shape[1] == 9:  # with the middles of its sides
            return np.concatenate([cells[:, [0, 4]].ravel(), cells[-1, [1, 5]], cells[::-1, [2, 6]].ravel(), cells[0, [3, 7]]])
        return cells[0] if len(cells) == 1 else np.concatenate([cells[:, 0], cells[-1, 1:3], cells[::-1, 3]])


def pieces_of_sides(folder):
    """Returns the number of pieces of enriched cells by effective.xml; 1, which joins nothing, if they have several."""
    interactions = find(read_scene(folder), "Interactions")
    elements = [find(entry, "Contact Element") for entry in ([] if interactions is None else interactions)]
    counts = {PIECES.get(element.get("value"), 1) for element in elements if element is not None} - {1}
    return counts.pop() if len(counts) == 1 else 1
