"""The message of an import without the compiled part of the module."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "python/ixos"


class MissingCoreTest(unittest.TestCase):
    """Each test has a folder with the scripts alone, as a build without the target ixos_python has it."""

    def setUp(self):
        self.build = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        shutil.copytree(SOURCE, self.build / "python/ixos", ignore=shutil.ignore_patterns("__pycache__"))

    def message(self):
        """Returns what the import prints."""
        done = subprocess.run([sys.executable, "-c", "import ixos"], capture_output=True, text=True, check=False,
                              cwd=self.build, env={"PYTHONPATH": str(self.build / "python")})
        self.assertEqual(done.returncode, 1)
        return done.stderr

    def test_the_message_has_the_command_that_builds_it(self):
        (self.build / "CMakeCache.txt").touch()
        self.assertIn(f"cmake --build {self.build} --target ixos_python", self.message())
        self.assertNotIn("_core'", self.message())

    def test_scripts_without_a_build_name_their_folder(self):
        self.assertIn(f"{self.build}/python/ixos has no compiled part of the module", self.message())

    def test_that_of_another_python_is_told_of(self):
        (self.build / "python/ixos/_core.cpython-30-x86_64-linux-gnu.so").touch()
        self.assertIn("is of another Python than this one, 3.", self.message())


if __name__ == "__main__":
    unittest.main()
