#!/usr/bin/python3
"""The lines of docs/extremes.md: what works stays right, what is refused is refused with its message and status.

IXOS_DRIVER names the driver (default: that of the release build).
"""
import os
import tempfile
import unittest

import bounces
import catalogue
import density
import dissipation
import gap
import law
import locking
import million
import obstacles
import ranks
import scaling
import step
import strain
from runs import EQUILIBRIUM, R0, ROOT, Runner, box, energy_scale, steps, wall

CONSERVING = ("Average Vector Field", "Energy-Momentum")


class LinesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="ixos-extremes-")
        cls.runner = Runner(cls.folder.name, os.environ.get("IXOS_DRIVER", ROOT / "build/release/drivers/ixos"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_scene(self, entries, *kinds, saying="", **options):
        """Runs a scene, which must end in one of these ways (default: completed)."""
        outcome = self.runner(str(len(list(self.runner.folder.iterdir()))), entries, **options)
        self.assertIn(outcome.kind, kinds or ["completed"], outcome.output)
        self.assertIn(saying, outcome.message)
        return outcome

    def test_a_body_released_in_the_depth_of_the_wall_keeps_its_first_row(self):
        for start in (1e-3, 0.1):
            outcome = self.run_scene({**gap.block(start * R0), **steps("Energy-Momentum", 1e-5, 10)}, "failed", "completed")
            row = outcome.run
            self.assertEqual(row["step"][0], 0)
            self.assertAlmostEqual(row["contact_force_y"][0] / (4 * gap.traction(start * R0)), 1, delta=1e-14)
            self.assertAlmostEqual(row["contact_energy"][0] / (4 * gap.energy(start * R0)), 1, delta=1e-14)
        self.run_scene({**gap.block(1e-3 * R0), **steps("Central Difference", 1e-5, 10)}, "failed",
                       saying="the stable step")

    def test_from_a_third_of_r0_to_a_thousand_the_energy_is_kept(self):
        for scheme in CONSERVING:
            for start in (0.32, 1e3):
                outcome = self.run_scene({**gap.block(start * R0), **steps(scheme, 1e-5, 200)})
                self.assertLess(outcome.energy_error(), 1e-11)

    def test_long_runs_keep_the_balance_with_the_closed_form_and_with_enough_points(self):
        for place, scene in bounces.SCENES.items():
            points = 16 if place == "spherical cavity" else 8
            for scheme, count in (("Average Vector Field", 0), ("Average Vector Field", points), ("Energy-Momentum", None)):
                run = self.run_scene({**scene(), **bounces.with_points(scheme, count)}).run
                self.assertLess(bounces.error(run), 1e-9, f"{place}, {scheme}")
                self.assertGreater(bounces.bounces(run), 3, place)
                if place == "spherical cavity" and scheme == "Energy-Momentum":
                    self.assertLess(bounces.moment_error(run), 1e-9)

    def test_work_is_stored_or_dissipated_over_a_long_run_with_branches_and_friction(self):
        run = self.run_scene(dissipation.bouncing()).run
        self.assertLess(dissipation.error(run), 1e-11)
        for name, value in dissipation.share(run).items():
            self.assertGreater(value, 0.1 * dissipation.total_work(run), name)

    def test_relaxation_times_and_friction_over_decades_keep_the_balance(self):
        for axis in ("relaxation", "friction"):
            _, values, entries = dissipation.AXES[axis]
            for value in (values[0], values[-1]):
                outcome = self.run_scene(dissipation.thrown(entries(value), "Average Vector Field"))
                self.assertLess(outcome.energy_error(), 1e-9, (axis, value))

    def test_a_scheme_that_loses_the_energy_is_told_of(self):
        outcome = self.run_scene({**gap.block(1e-3 * R0), **steps("Average Vector Field", 1e-3, 2)},
                                 saying="the scheme's energy error reached")
        self.assertGreater(outcome.energy_error(), 0.9)

    def test_steps_from_a_billionth_to_a_thousand(self):
        for scheme, length, bound in (("Average Vector Field", 1e-9, 1e-14), ("Energy-Momentum", 1e-9, 1e-14),
                                      ("Average Vector Field", 1e3, 1e-6), ("Energy-Momentum", 1e3, 1e-6)):
            outcome = self.run_scene(step.thrown(scheme, length))
            self.assertLess(outcome.energy_error(), bound, (scheme, length))
        # From rest the momentum is force times time, up to the square of the time.
        outcome = self.run_scene({**gap.block(step.START), **steps("Newmark", 1e-9, 200)})
        self.assertLess(abs(step.impulse_errors([outcome])[0]), 1e-9)
        self.run_scene({**gap.block(step.START), **steps("Newmark", 1e-16, 20, 1.0)}, "refused",
                       saying="lost in rounding")

    def test_an_impact_of_a_thousand_keeps_its_energy(self):
        for scheme in CONSERVING:
            outcome = self.run_scene({**gap.block(R0), **steps(scheme, 4e-6, 300),
                                      "Initial Conditions/Velocity": [0.0, -1e3]})
            self.assertLess(outcome.energy_error(), 1e-11, scheme)
            # The impact took place: the body was squeezed, and turned round at the wall.
            self.assertGreater(outcome.run["contact_force_y"].max(), 1)

    def test_the_energy_is_kept_before_round_rough_and_moving_obstacles(self):
        for scheme in CONSERVING:
            for entries, length, bound in ((obstacles.on_sphere(0.5), 1e-3, 1e-10), (obstacles.on_sphere(1e6), 1e-3, 1e-6),
                                           (obstacles.on_sphere(1e6, True), 1e-3, 1e-6),
                                           (obstacles.on_waves(5.0, "Vertical"), 1e-4, 1e-10),
                                           (obstacles.before_moving(1e3), 0.01 * R0 / 1e3, 1e-10)):
                outcome = self.run_scene({**entries, **steps(scheme, length, 300)})
                self.assertLess(outcome.energy_error(), bound, (scheme, entries))

    def test_the_energy_is_kept_with_every_law_at_both_ends_of_its_strengths(self):
        for name, (_, values, scene_of) in catalogue.CASES.items():
            for value in (values[0], values[-1]):
                outcome = self.run_scene({**scene_of(value), **steps("Energy-Momentum", 1e-3, 200)})
                self.assertLess(outcome.energy_error(), 1e-9, (name, value))

    def test_a_kink_needs_the_exact_mean(self):
        scene = catalogue.CASES["dugdale"][2](0.01)
        for scheme, bound in ((catalogue.EXACT, 1e-10), ("Average Vector Field", 1)):
            outcome = self.run_scene({**scene, **catalogue.scheme_of(scheme)})
            self.assertLess(outcome.energy_error(), bound)
        self.assertGreater(outcome.energy_error(), 1e-3)

    def test_units_over_twelve_decades_change_no_bit(self):
        for scheme, extra in (("Average Vector Field", {}), ("Bathe Composite", {}),
                              ("Average Vector Field", {"Materials/Ball/Element Formulation": "Enhanced"})):
            one = self.run_scene(scaling.ball(1.0, 1.0, 1.0, scheme, extra))
            for sign in (-1, 1):
                length, stress, time = 2.0 ** (-20 * sign), 2.0 ** (20 * sign), 2.0 ** (20 * sign)
                other = self.run_scene(scaling.ball(length, stress, time, scheme, extra))
                self.assertEqual(scaling.difference(other, one, {"total_energy": stress * length ** 2, "min_gap": length,
                                                               "time": time, "newton_iterations": 1}), "0", scheme)

    def test_without_density_the_motion_is_static(self):
        static = self.run_scene(density.pulled("Static", 1.0)).run["reaction_right_x"][-1]
        for value in (1e-20, 1e-300):
            for scheme in ("Bathe Composite", "Average Vector Field"):
                reaction = self.run_scene(density.pulled(scheme, value)).run["reaction_right_x"][-1]
                self.assertAlmostEqual(reaction / static, 1, delta=1e-11)
        self.run_scene(density.pulled("Central Difference", 1e-100), "failed", saying="is shorter than the shortest one allowed")
        # Without supports the acceleration, force over mass, is beyond all numbers.
        self.run_scene({**gap.block(EQUILIBRIUM), **steps("Newmark", 1e-3, 1), "Materials/Body/Density": 1e-310}, "refused",
                       saying="the acceleration cannot be solved for")
        self.run_scene(density.pulled("Newmark", 0.0), "refused", saying="Density: 0 is not allowed")

    def test_an_element_stretched_to_eleven_and_squeezed_to_a_hundredth(self):
        for dimension in (2, 3):
            for formulation in ("Standard", "Mean Dilatation"):
                for stretch, count in ((11.0, 10), (0.01, 100)):
                    outcome = self.run_scene(strain.stretched(dimension, 0.2, formulation, stretch, count))
                    exact = strain.stretch_stress(stretch, 0.2, dimension)
                    self.assertAlmostEqual(outcome.run["reaction_right_x"][-1] / exact, 1, delta=1e-9)

    def test_squeezed_blocks_hold_unless_enhanced(self):
        self.run_scene(strain.squeezed(2, 0.4999, "Mean Dilatation"))
        for ratio in (0.2, 0.4999):
            outcome = self.run_scene(strain.squeezed(2, ratio, "Enhanced"), "failed")
            self.assertLess(outcome.run["time"][-1], 0.985)  # the last load step ends at 0.99

    def test_locking_is_there_and_cured(self):
        def ratio(formulation):
            outcome = self.run_scene(locking.cantilever(2, 0.4999, formulation, [40, 4]))
            return locking.deflection(outcome, 2, locking.theory(2, 0.4999))
        self.assertLess(ratio("Standard"), 0.03)
        self.assertAlmostEqual(ratio("Mean Dilatation"), 1, delta=0.04)
        self.assertAlmostEqual(ratio("Enhanced"), 1, delta=0.03)
        self.assertAlmostEqual(ratio("Quadratic"), 1, delta=0.03)
        rubber = {**gap.block(1.1 * EQUILIBRIUM), **steps("Average Vector Field", 1e-3, 50)}
        almost = self.run_scene({**rubber, "Materials/Body/Poisson's Ratio": 0.49999})
        self.assertLess(almost.energy_error(), 1e-12)
        # Here the bulk stiffness may leave Newton's method no digits; a run that completes must still keep its energy.
        rigid = self.run_scene({**rubber, "Materials/Body/Poisson's Ratio": 0.4999999999}, "failed", "completed")
        if rigid.kind == "completed":
            self.assertLess(rigid.energy_error(), 1e-6)
        self.run_scene(locking.cantilever(2, 0.5, "Enhanced", [4, 1]), "refused", saying="Poisson's Ratio: 0.5 is not allowed")

    def test_ranks_without_elements_change_nothing(self):
        one = {**box((2, 2), (1, 1), (0, 1.1 * EQUILIBRIUM)), **wall(), **steps("Average Vector Field", 1e-4, 20)}
        four = {**box((4, 2), (4, 1), (0, 1.1 * EQUILIBRIUM)), **wall(), **steps("Central Difference", 1e-4, 20)}
        for entries in (one, four):
            alone = self.run_scene(entries)
            for count in (2, 6):
                self.assertLess(float(ranks.difference(self.run_scene(entries, ranks=count), alone)), 1e-11)

    def test_laws_over_decades(self):
        for length in (0.1, 1.0, 100.0):
            for energy in (0.1, 1e4):
                self.assertLess(law.peak_error(self.run_scene(law.at_peak(length, energy)), energy), 1e-14)
        for length, energy in ((0.1, 1e4), (100.0, 1e4), (10.0, 10.0)):
            outcome = self.run_scene({**law.body(length, energy, 1.2), **steps("Average Vector Field", 1e-3, 100)})
            self.assertLess(outcome.energy_error(), 1e-9, (length, energy))
        flattened = {**law.body(0.1, 0.1, 1.2), **steps("Average Vector Field", 1e-3, 200)}
        self.run_scene(flattened, "failed", "completed")
        self.run_scene({**flattened, **law.ADAPTIVE})

    def test_moduli_over_twelve_decades(self):
        for modulus, bound in ((1e-6, 1e-12), (1e6, 1e-9)):
            for scheme in CONSERVING:
                outcome = self.run_scene({**gap.block(1.1 * EQUILIBRIUM), **steps(scheme, 1e-4, 100),
                                          "Materials/Body/Young's Modulus": modulus})
                self.assertLess(outcome.energy_error(), bound, (scheme, modulus))

    def test_long_cells_are_told_of_and_bend_rightly_where_enhanced(self):
        def bent(formulation, aspect, saying=""):
            outcome = self.run_scene(locking.cantilever(2, 0.3, formulation, [8, 1], 8.0 * aspect), saying=saying)
            return locking.deflection(outcome, 2, locking.theory(2, 0.3, 8.0 * aspect))
        self.assertAlmostEqual(bent("Enhanced", 100), 1, delta=0.01)
        self.assertAlmostEqual(bent("Quadratic", 100), 1, delta=0.02)
        self.assertLess(bent("Standard", 100), 0.001)
        bent("Enhanced", 300, "has an aspect ratio of 300")

    def test_laws_beyond_what_numbers_hold_are_refused(self):
        self.run_scene({**gap.block(R0, Gamma_L=1e40), **steps("Newmark", 1e-3, 1)}, "refused", saying="too extreme")
        self.run_scene({**gap.block(-R0), **steps("Newmark", 1e-3, 1)}, "refused", saying="starts in or below the wall")

    def test_memory_does_not_grow(self):
        for scheme in ("Average Vector Field", "Central Difference"):
            few, many = (self.run_scene(million.scene(scheme, count)).run for count in (1000, 21000))
            growth = many.summary["peak_memory_bytes"] - few.summary["peak_memory_bytes"]
            # A field kept at each of 20,000 steps, 12 doubles, adds 1.9 MB; the allocator's rounding adds less than 1 MB.
            self.assertLess(growth, 1_000_000, scheme)
            self.assertLess(many.energy_error().max(), (1e-12 if scheme in CONSERVING else 1e-2) * energy_scale(many))


if __name__ == "__main__":
    unittest.main()
