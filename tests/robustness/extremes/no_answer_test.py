#!/usr/bin/python3
"""Scenes without an answer say so, with a status or a warning. IXOS_DRIVER names the driver."""
import os
import tempfile
import unittest

import no_answer
from runs import ROOT, Runner


class NoAnswerTest(unittest.TestCase):
    def test_no_scene_ends_in_silence(self):
        with tempfile.TemporaryDirectory(prefix="ixos-no-answer-") as folder:
            runner = Runner(folder, os.environ.get("IXOS_DRIVER", ROOT / "build/release/drivers/ixos"))
            for name, (entries, kind, words) in no_answer.SCENES.items():
                with self.subTest(name):
                    outcome = runner(name.replace(" ", "_"), entries)
                    warned = outcome.kind == "completed" and "ixos: warning: " in outcome.output
                    self.assertEqual("warned" if warned else outcome.kind, kind, outcome.output)
                    self.assertIn(words, outcome.message)  # which has no folders, and so not the name
            self.assertEqual(runner.defects, [])


if __name__ == "__main__":
    unittest.main()
