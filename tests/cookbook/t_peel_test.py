#!/usr/bin/python3
"""Tests the numbers of docs/cookbook/t-peel: the double cantilever beam, and the T-peel with equal and with different
meshes (15 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/cookbook/t_peel_test.py"""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/cookbook"))
import recipe  # noqa: E402

study = recipe.study("t-peel")
formulas = study.formulas
LENGTH = 40.0  # of the strips of the T-peel here: shorter than those of the page


def run(settings):
    with tempfile.TemporaryDirectory() as folder:
        return recipe.run("t-peel", {**recipe.QUIET, **settings}, folder + "/run")


def peel(upper, lower, both):
    return run({**study.meshes(upper, lower, LENGTH), **study.factors(both), **study.steps(36.0, 0.75)})


class TwoStrips(unittest.TestCase):
    def test_closed_forms_and_the_beam_on_the_law_agree_where_they_should(self):
        for row in study.known(formulas.STIFF)[-2:]:
            self.assertLess(abs(study.cantilever(row["opening"]) / row["force"] - 1), 0.025)
        last = study.known(formulas.SOFT)[-1]
        self.assertLess(abs(formulas.t_peel(formulas.SOFT) / last["force"] - 1), 2e-3)
        for row in study.known(formulas.STIFF)[-1:] + study.known(formulas.SOFT)[-1:]:
            self.assertAlmostEqual(study.balance(row["force"], row["angle"], row["modulus"]), 1, delta=3e-3)

    def test_a_double_cantilever_beam_is_two_beams_on_the_law(self):
        beam = run({**study.beams(), **study.steps(16.0, 0.5)})
        for row in study.known(formulas.STIFF):
            if row["opening"] >= 2:
                force, turned = study.at(beam, row["opening"])
                self.assertLess(abs(force / row["force"] - 1), 0.01)
                self.assertLess(abs(turned / row["angle"] - 1), 0.01)

    def test_a_t_peel_is_that_of_the_beam_and_both_arms_are_alike(self):
        t_peel = peel(80, 80, True)
        for row in study.known(formulas.SOFT)[1:3]:
            force, turned = study.at(t_peel, row["opening"])
            self.assertLess(abs(force / row["force"] - 1), 5e-3)
            self.assertAlmostEqual(study.balance(force, turned, formulas.SOFT), 1, delta=5e-3)
        upper, lower = study.forces(t_peel)
        np.testing.assert_allclose(upper, lower, rtol=1e-7, atol=1e-9)

    def test_different_meshes_have_the_same_force(self):
        upper, lower = study.forces(peel(80, 56, True))
        row = study.known(formulas.SOFT)[2]
        self.assertLess(abs((upper + lower)[-1] / 2 / row["force"] - 1), 0.01)


if __name__ == "__main__":
    unittest.main()
