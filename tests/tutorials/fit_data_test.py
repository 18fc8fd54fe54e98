#!/usr/bin/python3
"""Tests the program of docs/tutorials/fit-data/fit-data.md: it finds the modulus, the work of adhesion and the shift
that made its data (15 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/tutorials/fit_data_test.py"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import tutorial

PAGE = tutorial.ROOT / "docs/tutorials/fit-data/fit-data.md"
KNOWN = {"E": 7, "W": 30, "shift": 0.1}
MISSING = [name for name in ("ixos", "matplotlib", "scipy") if importlib.util.find_spec(name) is None]


class Fit(unittest.TestCase):
    @unittest.skipIf(MISSING, f"{', '.join(MISSING)}: not there")
    def test_finds_what_made_the_data(self):
        program = re.search(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)[1]
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "xml").symlink_to(tutorial.ROOT / "xml")
            paths = os.pathsep.join(sys.path)
            done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True,
                                  env={**tutorial.recipe.ENVIRONMENT, "PYTHONPATH": paths}, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue((pathlib.Path(folder) / "fit-data.png").exists())
        found = {name: (float(value), float(error)) for name, value, error in
                 re.findall(r"^(\w+) = (\S+) \+- (\S+)", done.stdout, re.MULTILINE)}
        self.assertEqual(found.keys(), KNOWN.keys())
        for name, known in KNOWN.items():
            value, error = found[name]
            self.assertLess(abs(value - known), 3 * error, name)
            self.assertLess(error, 0.03 * known, name)


if __name__ == "__main__":
    unittest.main()
