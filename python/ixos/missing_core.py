"""The message of an import that does not find the library of the module."""
import pathlib
import sys

FOLDER = pathlib.Path(__file__).absolute().parent


def explanation(folder=FOLDER):
    """Returns why the compiled part of the module in a folder cannot be imported, and the command that mends it."""
    built = sorted(folder.glob("_core.*.so"))
    if built:
        version = f"{sys.version_info.major}.{sys.version_info.minor}"
        return f"ixos: {built[0].name} in {folder} is of another Python than this one, {version}: {sys.executable}"
    build = next((parent for parent in folder.parents if (parent / "CMakeCache.txt").exists()), None)
    if build is None:
        return f"ixos: {folder} has no compiled part of the module: set PYTHONPATH to the folder python of a build"
    return ("ixos: the compiled part of the module is not built; the command for it is\n"
            f"    cmake --build {build} --target ixos_python")
