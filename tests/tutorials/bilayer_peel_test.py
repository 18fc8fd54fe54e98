#!/usr/bin/python3
"""Tests the numbers of docs/tutorials/bilayer-peel: Kendall's force, and the balance of energies (7 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/tutorials/bilayer_peel_test.py

The scene's mesh comes from the module ixos, in the build of the driver or on PYTHONPATH. Without it the test is
skipped."""
import pathlib
import tempfile
import unittest

import tutorial

ANGLE_FACTOR = 1 - 0.5**0.5  # 1 - cos(45 degrees)
WORK = 0.2  # [J/m^2]

mesh = tutorial.program("bilayer-peel", "mesh")
balance = tutorial.program("bilayer-peel", "balance")


@unittest.skipUnless(mesh, "the Python module ixos is not there")
class Peel(unittest.TestCase):
    def peel(self, settings):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "film.e")
            mesh.film(60).write(str(file))
            settings = {"Mesh/Exodus/File": file, tutorial.STEPS + "Time Step": 1.3, **settings}
            run = tutorial.run("bilayer-peel", settings, folder + "/run")
            return run, *balance.balance(tutorial.history(run))

    def test_without_friction_and_relaxation_the_force_is_kendalls(self):
        # so fast that no branch relaxes, and too light for inertia
        run, force, work, parts = self.peel(
            {"Units/Time": "100 ns", "Interactions/Adhesion/Friction/Type": "None",
             "Materials/Backing/Density": "1e-2 kg/m^3", "Materials/Soft Layer/Density": "1e-2 kg/m^3"})
        self.assertLess(parts["viscoelastic"], 0.005 * WORK)
        self.assertLess(abs(force * ANGLE_FACTOR / (WORK + parts["viscoelastic"]) - 1), 0.01)
        self.assertLess(abs(parts["adhesion"] / WORK - 1), 0.005)

    def test_the_work_is_the_energy_of_adhesion_and_what_is_dissipated(self):
        run, force, work, parts = self.peel({})
        self.assertLess(abs(work - sum(parts.values())), 1e-5 * work)
        self.assertLess(abs(parts["adhesion"] / WORK - 1), 0.005)
        # Kendall's balance with the dissipated energies, which follow from the histories and not from the force
        lost = parts["viscoelastic"] + parts["friction"]
        self.assertGreater(lost, 0.3 * WORK)
        self.assertLess(abs(force * ANGLE_FACTOR / (WORK + lost) - 1), 0.01)
        self.assertLess(run.energy_error().max(), 1e-6 * WORK * run["contact_measure_Adhesion"][0])


if __name__ == "__main__":
    unittest.main()
