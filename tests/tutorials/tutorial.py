"""What the tests of the tutorials share: runs of docs/tutorials/NAME/NAME.xml with other settings."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/cookbook"))
import recipe  # noqa: E402

STEPS = recipe.STEPS


def path(name, file):
    """Returns the path of a file of a tutorial."""
    return ROOT / "docs/tutorials" / name / file


def run(name, settings, folder):
    """Runs the scene of a tutorial without fields and checkpoints, unless settings ask for them. Returns a
    results.Run."""
    return recipe.run(f"../docs/tutorials/{name}/{name}", {**recipe.QUIET, **settings}, folder)
