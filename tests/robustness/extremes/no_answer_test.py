#!/usr/bin/python3
"""Scenes without an answer say so, with a status or a warning; sound ones draw no warning. IXOS_DRIVER names the
driver."""
import os
import tempfile
import unittest

import no_answer
import sound
from runs import ROOT, Runner

WARNING = "ixos: warning: "


class NoAnswerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="ixos-no-answer-")
        self.addCleanup(folder.cleanup)
        self.runner = Runner(folder.name, os.environ.get("IXOS_DRIVER", ROOT / "build/release/drivers/ixos"))

    def run_all(self, scenes, judge):
        """Runs scenes by name, and calls judge(name, outcome) for each."""
        for number, (name, entries) in enumerate(scenes.items()):
            with self.subTest(name):
                judge(name, self.runner(str(number), entries))
        self.assertEqual(self.runner.defects, [])

    def test_no_scene_ends_in_silence(self):
        def judge(name, outcome):
            _, kind, words = no_answer.SCENES[name]
            warned = outcome.kind == "completed" and WARNING in outcome.output
            self.assertEqual("warned" if warned else outcome.kind, kind, outcome.output)
            self.assertIn(words, outcome.message)

        self.run_all({name: scene[0] for name, scene in no_answer.SCENES.items()}, judge)

    def test_sound_scenes_draw_no_warning(self):
        def judge(_, outcome):
            self.assertEqual(outcome.kind, "completed", outcome.output)
            self.assertNotIn(WARNING, outcome.output)

        self.assertGreaterEqual(len(sound.SCENES), 40)
        self.run_all(sound.SCENES, judge)


if __name__ == "__main__":
    unittest.main()
