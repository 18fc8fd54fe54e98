"""Reads effective.xml; the error that all scripts report."""
import pathlib
import xml.etree.ElementTree

from result_files import FileError as ResultsError  # requested data are missing or damaged


def existing(folder):
    """The folder as a path, when it is one."""
    folder = pathlib.Path(folder)
    if not folder.is_dir():
        raise ResultsError(f"the folder {folder} does not exist")
    return folder


def read_scene(folder):
    """effective.xml as a tree, or None where there is no such file."""
    path = pathlib.Path(folder) / "effective.xml"
    if not path.is_file():
        return None
    try:
        return xml.etree.ElementTree.parse(path).getroot()
    except xml.etree.ElementTree.ParseError as error:
        raise ResultsError(f"{path}: {error}") from None


def is_axisymmetric(folder):
    """Whether the results are those of bodies of revolution, whose forces and energies are not per depth."""
    scene = read_scene(folder)
    geometry = None if scene is None else find(scene, "Mesh/Geometry")
    return geometry is not None and geometry.get("value") == "Axisymmetric"


def find(node, path):
    """The list or parameter at a path of names below a list ('*': the first list), or None."""
    for word in path.split("/"):
        entries = [] if node is None else list(node)
        node = next((entry for entry in entries
                     if entry.get("name") == word or (word == "*" and entry.tag == "ParameterList")), None)
    return node
