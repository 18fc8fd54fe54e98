#!/usr/bin/python3
"""Runs docs/examples/peel_strip.py in its small form and examines what it prints and writes."""
import importlib.util
import re
import subprocess
import sys

from support import ROOT, FolderTest, ixos, main


class PeelStripTest(FolderTest):
    def test_the_small_form(self):
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("matplotlib is not installed")
        done = subprocess.run([sys.executable, ROOT / "docs/examples/peel_strip.py", "--small", "--output",
                               self.folder / "out"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        energy, expected = map(float, re.search(r"contact energy (\S+), -150 W = (\S+) E0", done.stdout).groups())
        self.assertAlmostEqual(expected, -2.3244, places=4)  # 150 15^(1/3) pi/(8 25 2.5)
        self.assertAlmostEqual(energy, expected, delta=1e-3)
        forces = [float(force) for force in re.findall(r"largest force (\S+) N/m", done.stdout)]
        fronts = [float(front) for front in re.findall(r"sticks up to (\S+) nm", done.stdout)]
        self.assertEqual(len(forces), 3)
        self.assertEqual(forces, sorted(forces, reverse=True))  # a stronger wall needs a larger force,
        self.assertEqual(fronts, sorted(fronts, reverse=True))  # and holds more of the strip
        self.assertLess(fronts[-1], 150)
        for gamma in (20, 25, 50):
            results = ixos.results(self.folder / f"out/gamma-{gamma}")
            self.assertEqual(results.summary["status"], "completed")
            self.assertLess(results.summary["max_energy_error"], 1e-3 * results.summary["largest_energy"])
        self.assertGreater((self.folder / "out/peel-strip.png").stat().st_size, 10000)


if __name__ == "__main__":
    main()
