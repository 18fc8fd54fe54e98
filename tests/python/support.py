"""Scenes and helpers for the tests of the Python module. They need PYTHONPATH, and IXOS_DRIVER for the command ixos."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import ixos  # noqa: E402

try:
    from mpi4py.MPI import COMM_SELF as MINE  # of each rank alone
except ImportError:
    MINE = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
BALL = ROOT / "xml/ball.xml"
DRIVER = os.environ.get("IXOS_DRIVER", "ixos")


def free_block(velocity=(1.0, -2.0), steps=10):
    """A linear elastic block of 4 x 2 L0 and density 3 without walls, in flight."""
    return ixos.Scene({
        "Mesh": {"Type": "Box", "Box": {"Lengths": [4, 2], "Divisions": [4, 2]}},
        "Materials": {"Rubber": {"Density": 3.0}},
        "Initial Conditions": {"Velocity": velocity},
        "Time Integrator": {"Type": "Newmark", "Time Step Control": {"Final Time": 0.01 * steps, "Time Step": 0.01}}})


def pulled_block():
    """A block of 4 x 2 L0 between two walls: E = 8, nu = 0. Its right side moves by 0.04 L0 in 1 T0."""
    hold = {"Node Set": "left", "Components": "x"}
    return ixos.Scene({
        "Mesh": {"Type": "Box", "Box": {"Lengths": [4, 2], "Divisions": [4, 2]}},
        "Materials": {"Rubber": {"Model": "Linear Elastic", "Young's Modulus": 8, "Poisson's Ratio": 0}},
        "Histories": {"Pull": {"Type": "Ramp", "Ramp": {"Value": 0.04, "Length": 1, "Shape": "Cosine"}}},
        "Boundary Conditions": {"Hold": hold, "Guide": {"Node Set": "bottom", "Components": "y"},
                                "Pull": {"Node Set": "right", "Components": "x", "History": "Pull"}},
        "Time Integrator": {"Type": "Static", "Time Step Control": {"Final Time": 1, "Time Step": 0.25}},
        "Output": {"Reactions": ["right"]}})


def command(*arguments):
    """Runs the command ixos as a process that is no rank of this one's job. Returns its status and its messages."""
    own = {key: value for key, value in os.environ.items()
           if not key.startswith(("PMIX_", "OMPI_COMM_WORLD_", "OMPI_MCA_orte_", "OMPI_MCA_ess"))}
    done = subprocess.run([DRIVER, *map(str, arguments)], capture_output=True, text=True, env=own, check=False)
    return done.returncode, done.stderr


class FolderTest(unittest.TestCase):
    """A test that has a new folder on each rank."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ixos-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)


def main():
    """Runs the tests of the script. Warnings of made-up scenes are not shown; they have a test of their own."""
    outcome = unittest.main(module="__main__", warnings="ignore", exit=False).result
    sys.exit(1 if not outcome.wasSuccessful() else 77 if outcome.skipped else 0)  # 77: some were skipped
