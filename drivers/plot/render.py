"""Pictures of bodies in space, rendered by VTK without a window."""
import ctypes
import os
import shutil
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (the renderer itself)
from matplotlib import colormaps
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_HEXAHEDRON, VTK_PYRAMID,
                                           VTK_QUADRATIC_PYRAMID, VTK_QUADRATIC_TETRA, VTK_TETRA,
                                           VTK_TRIQUADRATIC_HEXAHEDRON, VTK_WEDGE, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

from results import ResultsError

SIZE = (1600, 1200)
LINES = (0.25, 0.25, 0.25)
VIEW = (0.6, -1.0, 0.4)  # from the body to the eye
# By the number of a cell's nodes: VTK's type and its order of nodes by Exodus' order: corners, edges, faces, the centre.
# VTK's pyramid has no node in the middle of its base.
VTK_CELLS = {4: (VTK_TETRA, range(4)), 10: (VTK_QUADRATIC_TETRA, range(10)), 5: (VTK_PYRAMID, range(5)),
             14: (VTK_QUADRATIC_PYRAMID, range(13)), 6: (VTK_WEDGE, range(6)), 8: (VTK_HEXAHEDRON, range(8)),
             18: (VTK_BIQUADRATIC_QUADRATIC_WEDGE, [*range(9), 12, 13, 14, 9, 10, 11, 15, 16, 17]),
             27: (VTK_TRIQUADRATIC_HEXAHEDRON, [*range(12), *range(16, 20), *range(12, 16), 23, 24, 25, 26, 21, 22, 20])}


def require_screen():
    """VTK aborts without an X display: without one the script starts itself again under xvfb-run."""
    if os.environ.get("DISPLAY"):
        try:
            library = ctypes.CDLL("libX11.so.6")
            library.XOpenDisplay.restype = ctypes.c_void_p
            if library.XOpenDisplay(None):
                return
        except OSError:
            pass
        raise ResultsError(f"VTK cannot render: the display {os.environ['DISPLAY']} does not answer (unset DISPLAY to "
                           "render under xvfb-run)")
    if not (shutil.which("xvfb-run") and shutil.which("xauth")):
        raise ResultsError("VTK cannot render without a display: install xvfb and xauth (apt-get install xvfb xauth)")
    sys.stdout.flush()
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", sys.executable, *sys.argv])


def body(fields, frame, values, colors):
    """Actors of the deformed body: its surface, a colour a cell, and the lines of its mesh or, if fine, its edges."""
    cells = fields.on_mesh(frame)[0].cells
    points = vtkPoints()
    points.SetData(numpy_to_vtk(fields.positions(frame), deep=True))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    counts = np.count_nonzero(cells >= 0, axis=1)
    grid.Allocate(len(counts))
    for cell, count in zip(cells, counts):
        kind, order = VTK_CELLS[count]
        grid.InsertNextCell(kind, len(order), cell[list(order)].tolist())
    grid.GetCellData().SetScalars(numpy_to_vtk(values, deep=True))
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for number, color in enumerate(colormaps.get_cmap(colors[0])(np.linspace(0, 1, 256))):
        table.SetTableValue(number, *color)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(colors[1].vmin, colors[1].vmax)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetAmbient(0.75)  # mostly flat light: the colours must match the colour bar
    look.SetDiffuse(0.25)
    look.SetInterpolationToFlat()
    look.SetLineWidth(2)
    look.SetEdgeColor(*LINES)
    if len(cells) < 5000:
        look.EdgeVisibilityOn()
        return [actor]
    # The lines of a fine mesh would hide the colours.
    edges = vtkFeatureEdges()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.SetFeatureAngle(50)
    edges.ColoringOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    outline = vtkActor()
    outline.SetMapper(mapper)
    outline.GetProperty().SetColor(*LINES)
    outline.GetProperty().SetLineWidth(3)
    outline.GetProperty().LightingOff()
    return [actor, outline]


def plate(low, high, wall):
    """The wall: a grey plate before the body, at a height or through a point across a normal."""
    source = vtkPlaneSource()
    if isinstance(wall, tuple):
        point, normal = wall
        middle, reach = 0.5 * (low + high), 0.6 * float(np.linalg.norm(high - low))
        middle = middle - (middle - point) @ normal * normal
        first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        first *= reach / np.linalg.norm(first)
        second = np.cross(normal, first)
        source.SetOrigin(*(middle - first - second))
        source.SetPoint1(*(middle + first - second))
        source.SetPoint2(*(middle - first + second))
    else:
        margin = 0.15 * float((high - low)[:2].max())
        source.SetOrigin(low[0] - margin, low[1] - margin, wall)
        source.SetPoint1(high[0] + margin, low[1] - margin, wall)
        source.SetPoint2(low[0] - margin, high[1] + margin, wall)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.72, 0.72, 0.72)
    actor.GetProperty().LightingOff()
    if isinstance(wall, tuple):
        actor.GetProperty().SetOpacity(0.4)  # it may stand between the body and the viewer
    return actor


def pictures(fields, frames, values, colors, wall, view=VIEW):
    """A picture (height, width, 3) of each frame, all seen from the direction `view`, without their common white
    margins."""
    require_screen()
    positions = np.concatenate([fields.positions(frame) for frame in frames])
    low, high = positions.min(axis=0), positions.max(axis=0)
    if wall is not None and not isinstance(wall, tuple):
        low[2], high[2] = min(low[2], wall), max(high[2], wall)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)  # large pictures, made smaller with the figure, need none
    window.SetSize(*SIZE)
    shots = []
    for frame, value in zip(frames, values):
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        for actor in body(fields, frame, value, colors):
            renderer.AddActor(actor)
        if wall is not None:
            renderer.AddActor(plate(low, high, wall))
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*view)
        camera.SetViewUp(0, 0, 1)
        camera.ParallelProjectionOn()
        renderer.ResetCamera(low[0], high[0], low[1], high[1], low[2], high[2])
        window.AddRenderer(renderer)
        window.Render()
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        shots.append(vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars()).reshape(SIZE[1], SIZE[0], 3)[::-1])
        window.RemoveRenderer(renderer)
    inked = (np.array(shots) < 255).any(axis=(0, 3))
    rows, columns = np.flatnonzero(inked.any(axis=1)), np.flatnonzero(inked.any(axis=0))
    return [shot[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1] for shot in shots]
