"""What the tests of drivers/plot share: the scripts' path, running them, and looking at what they write."""
import os
import pathlib
import runpy
import subprocess
import sys
import tempfile
import traceback
import unittest
import warnings

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot  # noqa: E402,F401 (imported here for all scripts)
from PIL import Image  # noqa: E402

PLOT = pathlib.Path(__file__).resolve().parents[2] / "drivers" / "plot"
sys.path.insert(0, str(PLOT))
DRIVER = os.environ.get("IXOS_DRIVER", "ixos")
FILTERS = list(warnings.filters)  # unittest shows more warnings
SCENES = pathlib.Path(os.environ.get("IXOS_XML", PLOT.parents[1] / "xml"))


def simulate(folder, settings, ranks=1, scene="ball.xml"):
    """A run of a scene with other settings."""
    options = [word for setting in settings for word in ("--set", setting)]
    launcher = [] if ranks == 1 else ["mpiexec", "-np", str(ranks)]
    subprocess.run([*launcher, DRIVER, SCENES / scene, "--quiet", "--output", folder, *options], check=True,
                   capture_output=True)


def run_as_main(path, arguments):
    """Runs a script as the interpreter does; returns its exit status."""
    for module, at in [(name, getattr(module, "__file__", None) or "") for name, module in sys.modules.items()]:
        if at.startswith(f"{PLOT}/"):
            del sys.modules[module]  # a script begins with modules of its own
    warnings.filters[:] = FILTERS
    sys.argv = [str(path), *arguments]
    try:
        runpy.run_path(str(path), run_name="__main__")
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:  # pylint: disable=broad-except
        traceback.print_exc()
        return 1
    return 0


def script(name, *arguments):
    """Runs a script of drivers/plot in a fork of this process: half of a script's time is the import of matplotlib."""
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as complaints:
        child = os.fork()
        if child == 0:
            status = 1
            try:
                sys.stdout, sys.stderr = output, complaints
                os.dup2(output.fileno(), 1)
                os.dup2(complaints.fileno(), 2)
                status = run_as_main(PLOT / name, [str(word) for word in arguments])
                output.flush()
                complaints.flush()
            finally:
                os._exit(status)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        output.seek(0)
        complaints.seek(0)
        return subprocess.CompletedProcess(name, status, output.read(), complaints.read())


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
