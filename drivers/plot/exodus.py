"""Reads fields.e, or its series of one file a rank, into numpy arrays through VTK."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOExodus import vtkExodusIIReader

from results import ResultsError, existing

# The outline of a plane cell: its nodes in turn (VTK's cell type: order; None as numbered).
OUTLINES = {5: None, 9: None, 22: [0, 3, 1, 4, 2, 5], 23: [0, 4, 1, 5, 2, 6, 3, 7], 28: [0, 4, 1, 5, 2, 6, 3, 7]}


class Fields:
    """The mesh and its fields over time, numbered as the whole mesh is, whatever the number of ranks.

    times: time of each frame; dimension: 2 or 3; coordinates: a row a node (VTK reads them in single precision, the
    fields in double); cells: nodes of each cell (a list of arrays, VTK's order); cell_types: VTK's types."""

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
        self.times = np.array([information.Get(key, i) for i in range(steps)])
        if not steps:
            raise ResultsError(f"{self.path} has no frames")
        self._frame = -1
        self._read_mesh()

    def _grids(self, frame):
        """The element blocks of all files at a frame."""
        if frame != self._frame:
            for reader in self._readers:
                reader.UpdateTimeStep(self.times[frame])
            self._frame = frame
        blocks = [reader.GetOutput().GetBlock(0) for reader in self._readers]
        return [block.GetBlock(i) for block in blocks for i in range(block.GetNumberOfBlocks())
                if block.GetBlock(i) is not None and block.GetBlock(i).GetNumberOfCells()]

    def _read_mesh(self):
        grids = self._grids(0)
        self.dimension = max(grid.GetCell(0).GetCellDimension() for grid in grids)
        node_ids = np.concatenate([vtk_to_numpy(grid.GetPointData().GetArray("GlobalNodeId")) for grid in grids])
        cell_ids = np.concatenate([vtk_to_numpy(grid.GetCellData().GetArray("GlobalElementId")) for grid in grids])
        _, self._first, place = np.unique(node_ids, return_index=True, return_inverse=True)
        self._order = np.argsort(cell_ids)
        points = np.concatenate([vtk_to_numpy(grid.GetPoints().GetData()) for grid in grids])
        self.coordinates = points[self._first, :self.dimension].astype(float)
        cells, types, offset = [], [], 0
        for grid in grids:
            nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
            ends = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
            cells += [place[offset + nodes[a:b]] for a, b in zip(ends[:-1], ends[1:])]
            types += [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
            offset += grid.GetNumberOfPoints()
        self.cells = [cells[i] for i in self._order]
        self.cell_types = np.array(types)[self._order]

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
        return self.nodal("displacement", frame)

    def element(self, name, frame):
        """An element field: a value a cell."""
        return self._gather(frame, name, "GetCellData")[self._order]

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
        return float(vtk_to_numpy(array)[frame])

    def polygons(self, frame):
        """Outlines of the cells of a plane body, deformed: an array (corners, 2) a cell."""
        if self.dimension != 2:
            raise ResultsError(f"{self.path}: the body is not plane")
        positions = self.coordinates + self.displacement(frame)
        outlines = [OUTLINES.get(kind) for kind in self.cell_types]
        return [positions[cell if outline is None else cell[outline]] for cell, outline in zip(self.cells, outlines)]

    def nearest_frame(self, time):
        """The frame at a time, at most half a frame's interval away."""
        frame = int(np.argmin(np.abs(self.times - time)))
        reach = 0.5 * float(np.diff(self.times).max()) if len(self.times) > 1 else 0.0
        if abs(self.times[frame] - time) > reach * (1 + 1e-9):
            raise ResultsError(f"{self.path} has no frame near time {time:g}: its {len(self.times)} frames go from "
                               f"{self.times[0]:g} to {self.times[-1]:g}")
        return frame


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
