"""Reads the files of a results folder into NumPy arrays: history.csv, summary.json, and fields.e or its series.

The scripts of drivers/plot and the Python module ixos share this file. It imports nothing of Ixos, because the scripts
work without the module too."""
import csv
import itertools
import json
import pathlib
import re

import numpy as np

COMPONENT = re.compile(r"(.+?)_?(XX|YY|ZZ|XY|YZ|ZX|X|Y|Z|1|2|3)")  # files of earlier versions have the underscore
NETCDF = b"CDF\x01", b"CDF\x02", b"CDF\x05", b"\x89HDF"  # how such files begin


class FileError(OSError):
    """A file or folder is missing or damaged, or could not be written or read. The message has one line."""


def read_history(path):
    """Returns the columns of history.csv by name; an empty cell is NaN.

    Leaves out a last row that is cut short: the run was killed, or still writes."""
    path = pathlib.Path(path)
    try:
        with open(path, newline="", encoding="utf-8") as file:
            names, *rows = list(csv.reader(file)) or [[]]
    except FileNotFoundError:
        raise FileError(f"the file {path} does not exist") from None
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    except (csv.Error, ValueError) as error:
        raise FileError(f"{path}: {error}") from None
    if not names:
        raise FileError(f"{path} is empty")
    if rows and len(rows[-1]) != len(names):
        rows.pop()
    for line, row in enumerate(rows, 2):
        if len(row) != len(names):
            raise FileError(f"{path}, line {line}: it has {len(row)} cells, the header {len(names)}")
    try:
        values = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows])
    except ValueError as error:
        raise FileError(f"{path}: {error}") from None
    return dict(zip(names, values.reshape(len(rows), len(names)).T))


def read_summary(path):
    """Returns summary.json as a dictionary, empty if the run has not ended."""
    path = pathlib.Path(path)
    try:
        summary = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None
    except ValueError as error:
        raise FileError(f"{path}: {error}") from None
    if not isinstance(summary, dict):
        raise FileError(f"{path}: it has no keys")
    return summary


# Corners of the sides of cells in space by their numbers of nodes, in Exodus' order.
TETRAHEDRON = [[0, 1, 3], [1, 2, 3], [0, 3, 2], [0, 2, 1]]
PYRAMID = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 4, 3], [0, 3, 2, 1]]
PRISM = [[0, 1, 4, 3], [1, 2, 5, 4], [0, 3, 5, 2], [0, 2, 1], [3, 4, 5]]
HEXAHEDRON = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [0, 4, 7, 3], [0, 3, 2, 1], [4, 5, 6, 7]]
SIDES = {4: TETRAHEDRON, 10: TETRAHEDRON, 5: PYRAMID, 14: PYRAMID, 6: PRISM, 18: PRISM, 8: HEXAHEDRON, 27: HEXAHEDRON}


def sides_of(plane, count):
    """The sides of a cell with so many nodes: their corners; of a plane cell with the nodes between them."""
    if not plane:
        return SIDES[count]
    corners = 3 if count in (3, 6) else 4
    return [[k, (k + 1) % corners, *([k + corners] if count in (6, 9) else [])] for k in range(corners)]


def joined_cells(blocks):
    """One array of the cells of blocks, a row a cell; -1 stands behind the nodes of cells with fewer than others."""
    most = max((cells.shape[1] for cells in blocks), default=0)
    wide = [np.pad(cells, ((0, 0), (0, most - cells.shape[1])), constant_values=-1) for cells in blocks]
    return np.concatenate(wide) if wide else np.zeros((0, 0), int)


def _parts_of(path):
    """The file, or those of its series of one file a rank; none where neither exists."""
    return [path] if path.is_file() else sorted(path.parent.glob(f"{path.name}.*.*"))


class _Series:
    """A file of fields, or its series of one file a rank. The attributes that Fields has are described there."""

    def __init__(self, path):
        paths = _parts_of(path)
        expected = 1 if path.is_file() else int(paths[0].name.split(".")[-2])
        if len(paths) != expected:
            raise FileError(f"{path}: the series has {len(paths)} files, not {expected}")
        self.parts = [_Part(own) for own in paths]
        self._read_mesh()
        first = self.parts[0]
        count = min(len(part.times) for part in self.parts)  # a run that still writes may be between two files
        self.times = first.times[:count]
        self.totals = {name: values[:count] for name, values in first.totals.items()}
        self.columns = {**_columns("node", first.names["node"]), **_columns("cell", first.names["cell"])}

    def _read_mesh(self):
        def gathered(name):
            return np.concatenate([getattr(part, name) for part in self.parts])

        ids, first, place = np.unique(gathered("node_ids"), return_index=True, return_inverse=True)
        self.mesh_nodes = ids - 1
        self.order = {"node": first, "cell": np.argsort(gathered("cell_ids"))}
        self.points = gathered("points")[first]
        starts = np.cumsum([0] + [len(part.node_ids) for part in self.parts])
        cells = [np.where(part.cells < 0, -1, place[start + part.cells])
                 for start, part in zip(starts, self.parts) if len(part.cells)]
        self.cells = joined_cells(cells)[self.order["cell"]]
        blocks = gathered("block_of_cell")[self.order["cell"]]
        self.blocks = {name: np.flatnonzero(blocks == name) for name in self.parts[0].blocks}

        def joined(kind):
            sets = {}
            for start, part in zip(starts, self.parts):
                for name, nodes in getattr(part, kind).items():
                    sets.setdefault(name, []).append(place[start + nodes])
            return {name: np.unique(np.concatenate(nodes)) for name, nodes in sets.items()}

        self.node_sets, self.side_set_nodes = joined("node_sets"), joined("side_sets")

    def has_mesh_of(self, other):
        return np.array_equal(self.points, other.points) and np.array_equal(self.cells, other.cells)

    def values(self, kind, column, frame):
        """Returns a variable at a frame, or at a slice of frames, for each node or cell; NaN if there is none."""
        if column not in self.parts[0].names[kind]:
            return np.full((*np.shape(self.times[frame]), len(self.order[kind])), np.nan)
        return np.concatenate([part.values(kind, column, frame) for part in self.parts], -1)[..., self.order[kind]]


def _numbered(folder, number):
    """The file of that number, from 1: of a stage or of an exchanged simulation, or of another mesh."""
    folder = pathlib.Path(folder)
    if number == 1:
        return folder / "fields.e"
    of_stage = folder / f"fields-{number}.e"
    return of_stage if _parts_of(of_stage) else folder / f"fields.e-s.{number:04}"


class Fields:
    """The mesh and the fields of fields.e, or of its series of one file a rank. Needs netCDF4.

    The frames of stages with other fields, which are in fields-2.e and so on, follow those of fields.e; those on other
    meshes, in fields.e-s.0002 and so on, have Fields of their own, see meshes(). A field that a
    stage lacks is NaN there.

    times: of the frames. dimension: 2 or 3. points: reference coordinates, a row a node. cells: the nodes of each cell,
    a row a cell; -1 stands behind the nodes of cells with fewer than others. mesh_nodes: for each node its number in
    the mesh, from 0. blocks and node_sets: numbers of cells and of nodes by name; side_set_nodes: those of side sets;
    nodes(name): those of either.
    totals: the global variables of all frames, such as total_energy, by name. Nodes and cells are in the order of the
    mesh, whatever the number of ranks.

    `fields["displacement"]` is an array of frames x nodes x components, `fields["jacobian"]` one of frames x cells;
    `fields.at("displacement", frame)` reads one frame. `list(fields)` has the names. A component has a name of its own
    too: "displacementX". A cell of a block without the field has NaN.
    """

    def __init__(self, folder: str | pathlib.Path, number: int = 1):
        """number: that of the first file, if the mesh has changed: see meshes()."""
        self.path = _numbered(folder, number)
        if not _parts_of(self.path):
            raise FileError(f"the file {self.path} does not exist, nor does a series {self.path}.N.0, ... (the scene "
                            "must set Output/Fields Interval to write one)")
        self._series = [_Series(self.path)]
        first = self._series[0]
        self.points, self.cells, self.mesh_nodes, self.blocks = first.points, first.cells, first.mesh_nodes, first.blocks
        self.node_sets, self.side_set_nodes = first.node_sets, first.side_set_nodes
        self.dimension = self.points.shape[1]
        self.next_number = None  # of the file with another mesh
        for later_number in itertools.count(number + 1):
            path = _numbered(folder, later_number)
            try:
                later = _Series(path) if _parts_of(path) else None
            except FileError:  # the run still writes it, or was killed then
                if (self.path.parent / "summary.json").is_file():
                    raise
                break
            if later is None:
                break
            if not later.has_mesh_of(first):  # an exchanged simulation, or a mesh that follows the front
                self.next_number = later_number
                break
            self._series.append(later)
        self.times = np.concatenate([series.times for series in self._series])
        self.totals = {name: np.concatenate([series.totals[name] for series in self._series]) for name in first.totals
                       if all(name in series.totals for series in self._series)}
        self._columns = {}
        for series in reversed(self._series):
            self._columns.update(series.columns)

    @classmethod
    def meshes(cls, folder: str | pathlib.Path) -> list["Fields"]:
        """Returns the fields on each mesh of a run whose mesh changes, one after the other."""
        found = [cls(folder)]
        while found[-1].next_number is not None:
            found.append(cls(folder, found[-1].next_number))
        return found

    def nodes(self, name: str) -> np.ndarray:
        """Returns the numbers of the nodes of a node set or a side set of the scene: "bottom"."""
        sets = {**self.side_set_nodes, **self.node_sets}
        if name not in sets:
            raise FileError(f"{self.path} has no set '{name}'; it has {', '.join(sorted(sets))}")
        return sets[name]

    def __iter__(self):
        return (name for name, (_, parts) in self._columns.items() if not any(
            name in others and name != whole for whole, (_, others) in self._columns.items()))

    def __getitem__(self, name: str) -> np.ndarray:
        return np.concatenate([self._values(series, name, slice(0, len(series.times))) for series in self._series])

    def at(self, name: str, frame: int | slice) -> np.ndarray:
        """Returns a field at a frame: a value, or a row of components, for each node or cell."""
        if isinstance(frame, slice):
            return self[name][frame]
        frame = range(len(self.times))[frame]
        for series in self._series:
            if frame < len(series.times):
                break
            frame -= len(series.times)
        return self._values(series, name, frame)

    def _values(self, series, name, frame):
        kind, names = self._column(name)
        columns = [series.values(kind, column, frame) for column in names]
        return columns[0] if names == [name] else np.stack(columns, -1)

    def components(self, name: str) -> list[str]:
        """Returns the names of a field's components, or of a field of one number."""
        return list(self._column(name)[1])

    def frames_with(self, name: str) -> np.ndarray:
        """Returns the numbers of the frames of the stages that have a field."""
        names = self._column(name)[1]
        has = [all(own in series.columns for own in names) for series in self._series]
        return np.flatnonzero(np.repeat(has, [len(series.times) for series in self._series]))

    def is_nodal(self, name: str) -> bool:
        """Returns whether a field has values for nodes; FileError if there is no such field."""
        return self._column(name)[0] == "node"

    def _column(self, name):
        """Whether a field is of nodes or cells, and its variables."""
        if name not in self._columns:
            raise FileError(f"{self.path} has no field '{name}'; it has {', '.join(sorted(self))}")
        return self._columns[name]

    def frame(self, time: float) -> int:
        """Returns the number of the frame nearest to a time, see nearest_frame()."""
        return nearest_frame(self.path, self.times, time)

    def information(self) -> dict:
        """Returns the file's records by key: scene, units, what wrote it."""
        lines = []
        for text in self._series[0].parts[0].records:
            if text.startswith("  ") and lines:
                lines[-1] += text[2:]
            else:
                lines.append(text)
        return dict(line.split(": ", 1) for line in lines if ": " in line)

    def __repr__(self):
        return (f"<ixos.Fields: {self.path}, {len(self.times)} frames, {len(self.points)} nodes, {len(self.cells)} "
                f"cells: {', '.join(self)}>")


def nearest_frame(path, times, time):
    """Returns the number of the nearest of the times of frames; a FileError if it is more than half a frame away."""
    if not len(times):
        raise FileError(f"{path} has no frames")
    frame = int(np.argmin(np.abs(times - time)))
    reach = 0.5 * float(np.diff(times).max()) if len(times) > 1 else 0.0
    if not abs(times[frame] - time) <= reach * (1 + 1e-9):
        raise FileError(f"{path} has no frame near time {time:g}: its {len(times)} frames go from {times[0]:g} to "
                        f"{times[-1]:g}")
    return frame


def _columns(kind, names):
    """The variables of each field: of each component, and of the components that differ in their ends alone."""
    joined = {}
    for name in names:
        found = COMPONENT.fullmatch(name)
        if found:
            joined.setdefault(found[1], []).append(name)
    return {name: (kind, parts) for name, parts in {**joined, **{name: [name] for name in names}}.items()}


class _Part:
    """One file of the series: ids of nodes and cells, and its own arrays in the order of the file."""

    def __init__(self, path):
        try:
            import netCDF4  # pylint: disable=import-outside-toplevel
        except ImportError:
            raise FileError(f"{path}: the Python package netCDF4 reads it (Debian: python3-netcdf4)") from None
        try:
            with open(path, "rb") as file:
                if not file.read(4).startswith(NETCDF):
                    raise FileError(f"{path} is not an Exodus file")
            self._data = netCDF4.Dataset(path)
            self._data.set_auto_maskandscale(False)
            self._read()
        except FileError:
            raise
        except (OSError, RuntimeError, LookupError, ValueError) as error:
            raise FileError(f"{path} is not an Exodus file, or damaged: {error}") from None

    def _read(self):
        sizes = {name: len(dimension) for name, dimension in self._data.dimensions.items()}
        count = sizes.get("num_nodes", 0)
        self.times = self._array("time_whole", np.zeros(0))
        self.node_ids = self._array("node_num_map", np.arange(1, count + 1))
        self.cell_ids = self._array("elem_num_map", np.arange(1, sizes.get("num_elem", 0) + 1))
        self.points = np.stack([self._array("coord" + axis, np.zeros(count)) for axis in "xyz"[:sizes["num_dim"]]], -1)
        self.blocks = self._texts("eb_names")
        self._sizes = [sizes.get(f"num_el_in_blk{number}", 0) for number in range(1, len(self.blocks) + 1)]
        self.block_of_cell = np.repeat(np.array(self.blocks, object), self._sizes)
        connected = [self._data[f"connect{number}"][:] - 1 for number, size in enumerate(self._sizes, 1) if size]
        self.cells = joined_cells(connected)
        self.node_sets = {name: self._data[f"node_ns{number}"][:] - 1 for number, name in
                          enumerate(self._texts("ns_names"), 1) if f"node_ns{number}" in self._data.variables}
        self.side_sets = {name: self._side_nodes(number) for number, name in
                          enumerate(self._texts("ss_names"), 1) if f"elem_ss{number}" in self._data.variables}
        self.names = {"node": self._texts("name_nod_var"), "cell": self._texts("name_elem_var")}
        totals = self._array("vals_glo_var", np.zeros((len(self.times), 0)))
        self.totals = dict(zip(self._texts("name_glo_var"), totals.T))
        self.records = self._texts("info_records")

    def _side_nodes(self, number):
        """The corners of the sides of a set, each once; nodes between them where a plane cell has them."""
        cells = self.cells[self._data[f"elem_ss{number}"][:] - 1]
        sides = self._data[f"side_ss{number}"][:] - 1
        plane, nodes = self.points.shape[1] == 2, [np.zeros(0, int)]
        counts = np.count_nonzero(cells >= 0, axis=1)
        for count in np.unique(counts):
            for side, own in enumerate(sides_of(plane, count)):
                nodes.append(cells[(counts == count) & (sides == side)][:, own].ravel())
        return np.unique(np.concatenate(nodes))

    def _array(self, name, otherwise):
        return self._data[name][:] if name in self._data.variables else otherwise

    def _texts(self, name):
        return [row.tobytes().split(b"\0")[0].decode() for row in self._array(name, ())]

    def values(self, kind, name, frame):
        """Returns a variable at a frame, or at a slice of frames, in the order of the file."""
        number = self.names[kind].index(name) + 1
        if kind == "node":
            return self._data[f"vals_nod_var{number}"][frame]
        rows = () if isinstance(frame, (int, np.integer)) else (len(self.times[frame]),)
        blocks = []
        for block, size in enumerate(self._sizes, 1):
            variable = f"vals_elem_var{number}eb{block}"
            there = variable in self._data.variables
            blocks.append(self._data[variable][frame] if there else np.full((*rows, size), np.nan))
        return np.concatenate(blocks, -1)
