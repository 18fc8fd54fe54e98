"""What the tests of drivers/plot share: the scripts' path, running them, and looking at what they write."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from PIL import Image

PLOT = pathlib.Path(__file__).resolve().parents[2] / "drivers" / "plot"
sys.path.insert(0, str(PLOT))
DRIVER = os.environ.get("IXOS_DRIVER", "ixos")
SCENES = pathlib.Path(os.environ.get("IXOS_XML", PLOT.parents[1] / "xml"))


def simulate(folder, settings, ranks=1, scene="ball.xml"):
    """A run of a scene with other settings."""
    options = [word for setting in settings for word in ("--set", setting)]
    launcher = [] if ranks == 1 else ["mpiexec", "-np", str(ranks)]
    subprocess.run([*launcher, DRIVER, SCENES / scene, "--quiet", "--output", folder, *options], check=True,
                   capture_output=True)


def script(name, *arguments):
    """Runs a script of drivers/plot."""
    return subprocess.run(["/usr/bin/python3", "-B", PLOT / name, *map(str, arguments)], capture_output=True, text=True,
                          check=False)


class ScriptTest(unittest.TestCase):
    """A test case that runs scripts and has a folder for what they read and write."""

    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.keep.name)

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def draw(self, name, *arguments):
        """Runs a script that must succeed; returns what it says it wrote."""
        done = script(name, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        return [pathlib.Path(line) for line in done.stdout.splitlines()]

    def assert_picture(self, path, kind, low, high):
        """A picture of that format whose width lies between limits, and that is not blank."""
        with Image.open(path) as image:
            image.load()
            self.assertEqual(image.format, kind)
            self.assertTrue(low <= image.width <= high, image.size)
            self.assertGreater(len(set(image.convert("L").getdata())), 10)

    def assert_refused(self, expected, name, *arguments):
        """Exit status 2 and one line that says what is wrong."""
        done = script(name, *arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(expected, done.stderr)
        self.assertEqual(done.stdout, "")
