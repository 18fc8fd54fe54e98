#!/usr/bin/python3
"""Scans in Python."""
import math

import numpy as np

from support import BALL, DRIVER, FolderTest, ixos, main

STEP = "Time Integrator/Time Step Control/Time Step"
SHORT = ["Time Integrator/Time Step Control/Final Time=0.02", "Output/Fields Interval=0"]


class ScanTest(FolderTest):
    def scan(self, vary, collect="final time", **options):
        return ixos.scan(BALL, vary, collect, set=SHORT, output=self.folder / "scan", driver=DRIVER, **options)

    def test_a_row_for_each_value(self):
        seen = []
        table = self.scan({STEP: [0.01, 0.005]}, observer=lambda row, done, reused: seen.append((done, reused)))
        self.assertEqual(table["Time Step"].tolist(), [0.01, 0.005])
        self.assertEqual(table["steps"].tolist(), [2, 4])
        np.testing.assert_allclose(table["final time"], 0.02, rtol=1e-12)
        self.assertEqual(seen, [(1, False), (2, False)])
        self.scan({STEP: "0.01:0.005:2"}, observer=lambda row, done, reused: seen.append((done, reused)))
        self.assertEqual(seen[2:], [(1, True), (2, True)])

    def test_words_are_varied_too(self):
        table = self.scan({"Time Integrator/Type": ["Newmark", "Midpoint"], STEP: [0.01]}, ["final time", "work"], jobs=2)
        self.assertEqual(table["Type"].tolist(), ["Newmark", "Midpoint"])
        self.assertEqual(table["status"].tolist(), ["completed"] * 2)
        self.assertTrue(all(math.isfinite(value) for value in table["work"]))

    def test_refusals_are_those_of_the_command(self):
        for vary, words in (({STEP: "1:2"}, "is no range"), ({"Tme": [1, 2]}, "Tme")):
            with self.assertRaisesRegex(ixos.InputError, words):
                self.scan(vary)

    def test_an_observer_may_stop_it(self):
        def stop(*_):
            raise RuntimeError("enough")
        with self.assertRaisesRegex(RuntimeError, "enough"):
            self.scan({STEP: [0.01, 0.005]}, observer=stop)


if __name__ == "__main__":
    main()
