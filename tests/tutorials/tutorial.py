"""What the tests of the tutorials share: runs of docs/tutorials/NAME/NAME.xml with other settings, and the programs
beside the scenes."""
import importlib.util
import pathlib
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/cookbook"))
import recipe  # noqa: E402

STEPS = recipe.STEPS
sys.path.append(str(pathlib.Path(recipe.DRIVER).resolve().parents[1] / "python"))  # the module ixos of the same build


def run(name, settings, folder):
    """Runs the scene of a tutorial without fields and checkpoints, unless settings ask for them. Returns a
    results.Run."""
    return recipe.run(f"../docs/tutorials/{name}/{name}", {**recipe.QUIET, **settings}, folder)


def history(run):
    """Returns the columns of a results.Run as a structured array, as the module ixos has them."""
    return np.rec.fromarrays(list(run.columns.values()), names=list(run.columns))


def program(name, file):
    """Returns docs/tutorials/NAME/FILE.py as a module, or None if the module ixos, which it needs, is missing."""
    if importlib.util.find_spec("ixos") is None:
        return None
    path = ROOT / "docs/tutorials" / name / (file + ".py")
    specification = importlib.util.spec_from_file_location(f"{name}_{file}", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def path(name, file):
    """Returns the path of a file of a tutorial."""
    return ROOT / "docs/tutorials" / name / file
