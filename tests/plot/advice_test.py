#!/usr/bin/python3
"""Tests of the picture and the report of an advice, on folders made here: tests/plot/advice_test.py"""
import json
import sys
import unittest

sys.dont_write_bytecode = True
from scripts import ScriptTest, script  # noqa: E402 (sets the path to the others)
from report_page import Page  # noqa: E402

COARSE = {"settings": ["Time Step=0.4"], "description": "Newmark, time step 0.4", "error": 0.03, "seconds": 1.0,
          "extrapolated": False}
FINE = {"settings": ["Time Step=0.2"], "description": "Newmark, time step 0.2", "error": 0.008, "seconds": 2.0,
        "extrapolated": False}
ADVICE = {
    "scene": "xml/strip.xml", "command": "ixos-study --advise xml/strip.xml", "version": "1.2.3", "status": "advised",
    "tolerance": 0.01, "budget_seconds": 60.0, "spent_seconds": 4.5, "problem": "", "recommended": FINE,
    "most_accurate": None, "confirmed": True, "fails_later": "",
    "verification": "Verified: half the step on the next finer mesh changes the quantities by at most 0.4 %.",
    "quantities": [{"name": "peak force", "estimate": 0.125, "change_by_perturbation": 1e-10, "error": 0.008,
                    "error_of": ["time step", "mesh"], "not_examined": [],
                    "parts": {"time step": {"error": 0.003, "examined": True, "reason": "asymptotic, of order 2"},
                              "mesh": {"error": 0.005, "examined": True, "reason": "<two sizes only>"}}}],
    "pareto": [COARSE, FINE],
    "other_tolerances": [{"tolerance": 0.1, "settings": COARSE}, {"tolerance": 0.001, "settings": None}],
    "choices": [{"direction": "material", "choice": "material Linear Elastic", "errors": [0.07], "seconds": 1.5}],
    "runs": [{"name": "a", "description": COARSE["description"], "good": True, "reason": "", "values": [0.129],
              "seconds": 1.0, "error": 0.03},
             {"name": "b", "description": FINE["description"], "good": True, "reason": "", "values": [0.1258],
              "seconds": 2.0, "error": 0.008},
             {"name": "c", "description": "Static", "good": False, "reason": "diverged", "values": [], "seconds": 0.5,
              "error": None}],
}


class AdviceTest(ScriptTest):
    def made(self, place, **changes):
        """Returns a folder with an advice."""
        folder = self.folder / place
        folder.mkdir()
        (folder / "advice.json").write_text(json.dumps({**ADVICE, **changes}), encoding="utf-8")
        return folder

    def test_picture_and_report(self):
        folder = self.made("advised")
        written = [path.name for path in self.draw("advice.py", folder)]
        self.assertEqual(written, ["advice.png", "advice.svg", "report.html"])
        self.assert_picture(folder / "advice.png", "PNG", 1000, 2200)
        svg = (folder / "advice.svg").read_text(encoding="utf-8")
        for word in ("processor time [s]", "tolerance", "recommended", "Pareto set", "Advice: strip"):
            self.assertIn(word, svg)
        page = Page(folder)
        for words in ("Within the tolerance 1 %: Newmark, time step 0.2. The error is at most 0.8 %; a run takes 2 s.",
                      'ixos xml/strip.xml \\ --set "Time Step=0.2"', "changes the quantities by at most 0.4 %",
                      "3 runs of 4.5 s together", "ixos-study --advise xml/strip.xml", "<two sizes only>"):
            self.assertIn(words, page.text)
        self.assertEqual(page.table("choice", "error of peak force", "processor s"),
                         [["material Linear Elastic", "7 %", "1.5"]])
        self.assertEqual(page.table("tolerance", "settings", "processor s"),
                         [["10 %", "Newmark, time step 0.4", "1"], ["0.1 %", "no settings known", "–"]])
        runs = page.table("run", "reason", "peak force", "error, at most", "processor s")
        self.assertEqual(runs[2], ["Static", "diverged", "–", "–", "0.5"])
        self.assertEqual(page.source.count('<tr class=best>'), 2)  # the sum of errors, and the recommended run
        self.assertNotRegex(page.source, r"(?i)(src|href)\s*=\s*[\"']?(https?:)?//|@import|url\(")

    def test_no_settings(self):
        folder = self.made("unreachable", status="unreachable", recommended=None, most_accurate=COARSE,
                           verification="")
        self.draw("advice.py", folder)
        self.assertIn("The smallest error seen is 3 %: Newmark, time step 0.4.", Page(folder).text)

    def test_what_was_not_examined_is_in_no_bound(self):
        one = {**ADVICE["quantities"][0], "error_of": ["time step"], "not_examined": ["mesh", "surface points"],
               "parts": {"time step": {"error": 0.008, "examined": True, "reason": "asymptotic, of order 2"},
                         "mesh": {"error": None, "examined": False, "reason": "not examined"}}}
        folder = self.made("open", quantities=[one], fails_later="the step is too short")
        self.draw("advice.py", folder)
        page = Page(folder)
        self.assertIn("at most 0.8 % without what was not examined: mesh, surface points; a run takes 2 s.", page.text)
        self.assertIn("That run fails after the times that decide the quantities: the step is too short.", page.text)
        rows = page.table("quantity", "of", "how it is known", "error, at most")
        self.assertEqual([row[-1] for row in rows], ["0.8 %", "not examined", "0.8 %"])
        self.assertEqual(rows[-1][1], "all that was examined")

    def test_a_plane_scene(self):
        folder = self.made("plane", plane={"scene": "out/plane.xml", "depth": 3.0, "difference": 1e-12})
        self.draw("advice.py", folder)
        page = Page(folder)
        self.assertIn("Two dimensions will do; on the coarsest mesh they change the quantities by 1e-10 %.", page.text)
        self.assertIn("ixos out/plane.xml ", page.text)

    def test_no_errors_give_no_picture(self):
        told = "The scene is chaotic for peak force."
        folder = self.made("chaotic", status="chaotic", recommended=None, verification="", problem=told, pareto=[],
                           other_tolerances=[], choices=[], runs=[{**ADVICE["runs"][0], "error": None}])
        self.assertEqual([path.name for path in self.draw("advice.py", folder)], ["report.html"])
        self.assertIn(told, Page(folder).text)

    def test_what_is_wrong_is_said_on_one_line(self):
        folder = self.made("damaged")
        (folder / "advice.json").write_text("{")
        self.assert_refused("advice.json: Expecting", "advice.py", folder)
        (folder / "advice.json").unlink()
        self.assert_refused("does not exist", "advice.py", folder)
        self.assertEqual(script("advice.py").returncode, 2)


if __name__ == "__main__":
    unittest.main()
