"""Reads fields.e, or its series of one file a rank, into numpy arrays through VTK."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOExodus import vtkExodusIIReader

import units
from scene_file import ResultsError, existing, find, read_scene

# The outline of a plane cell: its nodes in turn (VTK's cell type: order; None as numbered).
OUTLINES = {5: None, 9: None, 22: [0, 3, 1, 4, 2, 5], 23: [0, 4, 1, 5, 2, 6, 3, 7], 28: [0, 4, 1, 5, 2, 6, 3, 7]}

NODE_SETS = 7  # VTK's block of them

# Pieces of a plane cell's side by contact element: fields.e has a cell for each.
PIECES = {"Q1C2": 2, "Q1C3": 3, "Q1C4": 4, "Q1CH": 4}


class Fields:
    """The mesh and its fields over time, numbered as the whole mesh is, whatever the number of ranks.

    times: time of each frame; dimension: 2 or 3; coordinates: a row a node (VTK reads them in single precision, the
    fields in double); cells: nodes of each cell (a list of arrays, VTK's order); cell_types: VTK's types; wholes: for
    each cell of the scene's mesh its pieces in the file, more than one where a plane cell's side is enriched. All is
    in the units of the axes."""

    def __init__(self, folder):
        vtkObject.GlobalWarningDisplayOff()
        self.path = existing(folder) / "fields.e"
        paths = [self.path] if self.path.is_file() else sorted(self.path.parent.glob("fields.e.*.*"))
        if not paths:
            raise ResultsError(f"the file {self.path} does not exist, nor does a series {self.path}.N.0, ... (the "
                               "scene must set Output/Fields Interval to write one)")
        expected = 1 if self.path.is_file() else int(paths[0].name.split(".")[2])
        if len(paths) != expected:
            raise ResultsError(f"{self.path}: the series has {len(paths)} files, not {expected}")
        self._readers = [open_file(path) for path in paths]
        steps = min(reader.GetNumberOfTimeSteps() for reader in self._readers)
        information = self._readers[0].GetOutputInformation(0)
        key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        self._steps = [information.Get(key, i) for i in range(steps)]
        self._scales = units.scales(folder)
        self.times = np.array(self._steps) * self._factor("time")
        if not steps:
            raise ResultsError(f"{self.path} has no frames")
        self._frame = -1
        self._read_mesh()

    def _grids(self, frame):
        """The element blocks of all files at a frame, those with cells."""
        if frame != self._frame:
            for reader in self._readers:
                reader.UpdateTimeStep(self._steps[frame])
            self._frame = frame
        return [grid for _, grid in self._named_grids()]

    def _named_grids(self):
        """The names and the blocks."""
        files = [reader.GetOutput().GetBlock(0) for reader in self._readers]
        return [(file.GetMetaData(i).Get(vtkCompositeDataSet.NAME()), file.GetBlock(i)) for file in files
                for i in range(file.GetNumberOfBlocks())
                if file.GetBlock(i) is not None and file.GetBlock(i).GetNumberOfCells()]

    def _factor(self, quantity):
        return units.factor(self._scales, quantity, 2) if quantity else 1.0

    def _read_mesh(self):
        grids = self._grids(0)
        self.dimension = max(grid.GetCell(0).GetCellDimension() for grid in grids)
        node_ids = np.concatenate([vtk_to_numpy(grid.GetPointData().GetArray("GlobalNodeId")) for grid in grids])
        cell_ids = np.concatenate([vtk_to_numpy(grid.GetCellData().GetArray("GlobalElementId")) for grid in grids])
        self._node_ids, self._first, place = np.unique(node_ids, return_index=True, return_inverse=True)
        self._order = np.argsort(cell_ids)
        points = np.concatenate([vtk_to_numpy(grid.GetPoints().GetData()) for grid in grids])
        self.coordinates = points[self._first, :self.dimension].astype(float) * self._factor("length")
        cells, types, offset = [], [], 0
        for grid in grids:
            nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
            ends = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
            cells += [place[offset + nodes[a:b]] for a, b in zip(ends[:-1], ends[1:])]
            types += [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
            offset += grid.GetNumberOfPoints()
        self.cells = [cells[i] for i in self._order]
        self.cell_types = np.array(types)[self._order]
        self.wholes = self._join_pieces()

    def _join_pieces(self):
        """The cells of the file by cell of the scene's mesh: pieces have consecutive numbers in their block."""
        pieces = pieces_of_sides(self.path.parent) if self.dimension == 2 else 1
        ids = {}
        for name, grid in self._named_grids():
            ids.setdefault(name, []).append(vtk_to_numpy(grid.GetCellData().GetArray("GlobalElementId")))
        wholes, start = [], 0
        for name, parts in sorted(ids.items(), key=lambda item: min(map(np.min, item[1]))):
            count = sum(map(len, parts))
            size = pieces if "_contact" in name and count % pieces == 0 else 1
            wholes += list(np.arange(start, start + count).reshape(-1, size))
            start += count
        return wholes

    def _gather(self, frame, name, data):
        """An array of all blocks. VTK joins the components nameX, nameY; files of earlier versions have 'name_'."""
        arrays = []
        for grid in self._grids(frame):
            attributes = getattr(grid, data)()
            array = attributes.GetArray(name) or attributes.GetArray(name + "_")
            if array is None:
                known = sorted(attributes.GetArrayName(i).rstrip("_") for i in range(attributes.GetNumberOfArrays()))
                known = [word for word in known if not word.startswith(("Global", "Object", "Pedigree"))]
                raise ResultsError(f"{self.path} has no field '{name}'; it has {', '.join(known)}")
            arrays.append(vtk_to_numpy(array))
        return np.concatenate(arrays)

    def nodal(self, name, frame):
        """A nodal vector (displacement, velocity, ..., reaction): a row a node; of a scalar (gap) a value a node."""
        values = self._gather(frame, name, "GetPointData")[self._first]
        return values if values.ndim == 1 else values[:, :self.dimension]

    def displacement(self, frame):
        """Displacements: a row a node."""
        return self.nodal("displacement", frame) * self._factor("length")

    def element(self, name, frame):
        """An element field: a value a cell."""
        return self._gather(frame, name, "GetCellData")[self._order] * self._factor(units.field_quantity(name))

    def of_wholes(self, values):
        """Values of cells, a value for each whole cell: its pieces have the same."""
        return values[[whole[0] for whole in self.wholes]]

    def node_set(self, name, frame):
        """Deformed places of the nodes of a set, a row a node; none where no file has nodes of it. A node set with the
        name of a side set is called name_nodes in the file."""
        numbers = []
        names = (name, name + "_nodes")
        for reader in self._readers:
            for known in names:
                reader.SetObjectStatus(reader.NODE_SET, known, 1)
            reader.UpdateTimeStep(self._steps[frame])
            sets = reader.GetOutput().GetBlock(NODE_SETS)
            for i in range(sets.GetNumberOfBlocks()):
                if sets.GetBlock(i) is not None and sets.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) in names:
                    numbers.append(vtk_to_numpy(sets.GetBlock(i).GetPointData().GetArray("GlobalNodeId")))
        there = np.isin(self._node_ids, np.concatenate(numbers)) if numbers else np.zeros(len(self._node_ids), bool)
        return (self.coordinates + self.displacement(frame))[there]

    def information(self):
        """The file's records by key: scene, units, what wrote it."""
        array = self._grids(0)[0].GetFieldData().GetArray("Info_Records")
        if array is None:
            return {}
        texts = [bytes(row).split(b"\0")[0].decode() for row in vtk_to_numpy(array).astype(np.uint8)]
        lines = []
        for text in texts:
            if text.startswith("  ") and lines:
                lines[-1] += text[2:]
            else:
                lines.append(text)
        return dict(line.split(": ", 1) for line in lines if ": " in line)

    def total(self, name, frame):
        """A global variable, such as total_energy, at a frame; VTK gives all frames at once."""
        array = self._grids(frame)[0].GetFieldData().GetArray(name)
        if array is None:
            raise ResultsError(f"{self.path} has no global variable '{name}'")
        return float(vtk_to_numpy(array)[frame]) * units.factor(self._scales, "energy", self.dimension)

    def polygons(self, frame):
        """Outlines of the whole cells of a plane body, deformed: an array (corners, 2) a cell."""
        if self.dimension != 2:
            raise ResultsError(f"{self.path}: the body is not plane")
        positions = self.coordinates + self.displacement(frame)
        return [positions[self._outline(whole)] for whole in self.wholes]

    def _outline(self, whole):
        """The nodes around a whole cell. The first side of its pieces is the enriched one, the third the one opposite."""
        cells = [self.cells[piece] for piece in whole]
        if len(cells) == 1:
            order = OUTLINES.get(self.cell_types[whole[0]])
            return cells[0] if order is None else cells[0][order]
        return np.array([cell[0] for cell in cells] + [cells[-1][1], cells[-1][2]] + [cell[3] for cell in cells[::-1]])

    def nearest_frame(self, time):
        """The frame at a time, at most half a frame's interval away."""
        frame = int(np.argmin(np.abs(self.times - time)))
        reach = 0.5 * float(np.diff(self.times).max()) if len(self.times) > 1 else 0.0
        if abs(self.times[frame] - time) > reach * (1 + 1e-9):
            raise ResultsError(f"{self.path} has no frame near time {time:g}: its {len(self.times)} frames go from "
                               f"{self.times[0]:g} to {self.times[-1]:g}")
        return frame


def pieces_of_sides(folder):
    """Returns the number of pieces of enriched cells by effective.xml; 1, which joins nothing, if they have several."""
    interactions = find(read_scene(folder), "Interactions")
    elements = [find(entry, "Contact Element") for entry in ([] if interactions is None else interactions)]
    counts = {PIECES.get(element.get("value"), 1) for element in elements if element is not None} - {1}
    return counts.pop() if len(counts) == 1 else 1


def open_file(path):
    """A reader with all fields on and displacements as data, not applied."""
    reader = vtkExodusIIReader()
    with open(path, "rb") as file:
        is_netcdf = file.read(4) in (b"CDF\x01", b"CDF\x02", b"CDF\x05", b"\x89HDF")
    if not is_netcdf or not reader.CanReadFile(str(path)):
        raise ResultsError(f"{path} is not an Exodus file")
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    for kind in (reader.NODAL, reader.ELEM_BLOCK, reader.GLOBAL):
        reader.SetAllArrayStatus(kind, 1)
    reader.SetApplyDisplacements(0)
    reader.GenerateGlobalNodeIdArrayOn()
    reader.GenerateGlobalElementIdArrayOn()
    return reader
