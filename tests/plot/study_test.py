#!/usr/bin/python3
"""Tests of the pictures and the report of studies, on folders made from formulas: tests/plot/study_test.py"""
import csv
import itertools
import json
import math
import pathlib
import re
import sys
import unittest

import numpy as np

sys.dont_write_bytecode = True
from scripts import ScriptTest, script  # noqa: E402 (sets the path to the others)
import study  # noqa: E402
import style  # noqa: E402
from report_page import Page  # noqa: E402
from results import ResultsError  # noqa: E402
from study_report import command  # noqa: E402
from study_results import Study  # noqa: E402
from synthetic_study import ELEMENTS, REASON, SCHEMES, STEPS, make, write_data, write_rows  # noqa: E402

PICTURES = [f"work-precision-{word}.{ending}" for word in ("energy", "momentum", "force", "peak-force")
            for ending in ("png", "svg")]  # neither position nor work has a known error


class StudyTest(ScriptTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.strip = make(cls.folder / "strip")
        cls.done = script("study.py", cls.strip)

    def drawn(self, folder):
        """Draws a study; returns the names of what was written, and the page."""
        return [path.name for path in self.draw("study.py", folder)], Page(folder)

    def changed(self, place, change_rows=None, **data):
        """A small study with other rows (change_rows changes their list) and other entries."""
        folder = make(self.folder / place, SCHEMES[:2], ELEMENTS[:1], STEPS[:3])
        if change_rows:
            with open(folder / "study.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            change_rows(rows)
            write_rows(folder, rows)
        write_data(folder, {**json.loads((folder / "study.json").read_text()), **data})
        return folder

    def test_pictures_and_report(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        written, page = [pathlib.Path(line).name for line in self.done.stdout.splitlines()], Page(self.strip)
        self.assertEqual(set(written), {*PICTURES, "report.html"})
        self.assertEqual(written[0], "work-precision-force.png")  # the measure that matters first
        self.assertEqual(sorted(path.name for path in self.strip.iterdir()),
                         sorted([*written, "study.csv", "study.json"]))
        for name in PICTURES[::2]:
            self.assert_picture(self.strip / name, "PNG", 1200, 2200)
        svg = (self.strip / "work-precision-force.svg").read_text()
        for word in (*SCHEMES, *ELEMENTS, "wall-clock time [s]", "relative error of the force", "tolerance", "failed",
                     "Pareto set", "recommended", "labels: time step", "Newmark, Q1C4", "Peeling of a strip"):
            self.assertIn(word, svg)
        energy = (self.strip / "work-precision-energy.svg").read_text()
        self.assertNotIn("tolerance", energy)
        self.assertIn("on the bottom edge: below 1e-17", energy)
        self.assertNotIn("on the bottom edge", svg)
        self.assertLess(page.text.index("Recommendation"), page.text.index("Error over cost"))
        self.assertIn("This is the cheapest run.", page.text)
        for svg_text, there in ((svg, True), (energy, False)):
            self.assertEqual("reference's own error" in svg_text.replace("&#39;", "'"), there)
        self.assertIn('ixos xml/strip.xml \\ --set "Time Integrator/Type=Generalized-Alpha"', page.text)
        self.assertRegex(page.text, r"wall-clock time [\d.]+ s, processor time [\d.]+ s, Newton iterations \d+, "
                                    r"peak force 1\.\d+, work 0,")
        self.assertRegex(page.text, r"error of the force 0\.00\d+ ± 0\.0007, error of the peak force 0\.00\d+\.")
        for words in ("60 runs: 46 completed, 14 diverged", "Average Vector Field, time step 0.001",
                      "strip.study/reference", "Its own errors are taken from a run with twice",
                      "work_error is blank: nothing is pulled.", "Output/Fields Interval=0",
                      "ixos-study strip-study.xml"):
            self.assertIn(words, page.text)

    def test_tables(self):
        page = Page(self.strip)
        rows = {row[0]: row for row in page.table("run", "scheme", "element", "time step", "status", "reason")}
        self.assertEqual(len(rows), 60)
        self.assertEqual(rows["Newmark-Q1C1-0.1"][1:8], ["Newmark", "Q1C1", "0.1", "✗ diverged", REASON, "–", "–"])
        self.assertEqual(rows["Energy-Momentum-Q1C1-0.1"][4:8], ["✓ completed", "", "0", "0"])
        self.assertEqual(page.table("error of the", "reference's own error"), [["force", "0.0007"]])
        lines = {tuple(row[:2]): row[2:] for row in page.table("scheme", "element", *STEPS)}
        self.assertEqual(len(lines), 12)
        self.assertEqual(lines["Newmark", "Q1C1"][:3], ["✗ diverged; at time 31.25"] * 3)
        self.assertEqual([cell[:11] for cell in lines["Newmark", "Q1C1"][3:]], ["✓ completed"] * 2)
        self.assertRegex(lines["Newmark", "Q1C1"][4], r"error 0.0014, within$")
        self.assertRegex(lines["Energy-Momentum", "Q1C1"][0], r"error 0\.\d+$")
        pareto = [rows for rows in page.tables if "relative error" in rows[0]]
        known = json.loads((self.strip / "study.json").read_text())["pareto"]
        self.assertEqual([[row[0] for row in rows[1:]] for rows in pareto],
                         [known["error_force"], known["error_energy"], known["error_momentum"], known["peak_error"]])

    def test_the_same_study_gives_the_same_files(self):
        files = [self.strip / name for name in (*PICTURES, "report.html")]
        before = [path.read_bytes() for path in files]
        self.drawn(self.strip)
        for path, content in zip(files, before):
            self.assertTrue(path.read_bytes() == content, path.name)
        self.assertNotIn(b"<dc:date>", before[1])

    def test_the_report_needs_no_other_file(self):
        page = Page(self.strip)
        self.assertEqual({tag for tag, _ in page.tags} & {"script", "link", "iframe", "object", "a", "base"}, set())
        pictures = [attributes["src"] for tag, attributes in page.tags if tag == "img"]
        self.assertEqual(len(pictures), 4)
        for source in pictures:
            self.assertRegex(source, r"^data:image/svg\+xml;base64,[A-Za-z0-9+/]+=*$")
        self.assertNotRegex(page.source, r"(?i)(src|href)\s*=\s*[\"']?(https?:)?//|@import|url\(")
        self.assertNotRegex(re.sub(r"data:[^\"]*", "", page.source), r"https?://")
        self.assertIn("prefers-color-scheme: dark", page.source)
        self.assertEqual(page.source.count("<table>"), page.source.count('<div class="scroll" tabindex="0"><table>'))

    def test_text_is_shown_as_it_is(self):
        nasty = ["<b>&", '"x" onload="y', "$a_1$ $b", "_under", "'single'", "x, y\nz"]
        names = dict(zip(["scheme", "element", "time step"], ["<i>scheme</i>", "# of $ & $", "_step"]))
        folder, schemes = make(self.folder / "nasty", elements=["<b>Q1C1</b>"]), dict(zip(SCHEMES, nasty))
        with open(folder / "study.csv", newline="", encoding="utf-8") as file:
            rows = [{names.get(column, column): "<b>Q1C1</b>" if column == "element" else schemes.get(cell, cell)
                     for column, cell in row.items()} for row in csv.DictReader(file)]
        for row in rows:
            row["reason"] = row["reason"] and "<script>alert(1)</script>"
        write_rows(folder, rows)
        data = json.loads((folder / "study.json").read_text())
        data["axes"] = [{"name": names["scheme"], "values": nasty},
                        {"name": names["element"], "values": ["<b>Q1C1</b>"]},
                        {"name": names["time step"], "values": STEPS}]
        data["recommendation"].update(sentence="<u>Take</u> this & go.", settings=['A/B="$x`" \\', "C=<1>"])
        write_data(folder, {**data, "name": "<b>&", "connect": "_step", "scene": "my <scene>.xml", "common": ["<c>&d"],
                            "command": "study <e>", "reference": {
                                "description": "<f>", "folder": "<g>", "judgement": "<h>", "own_errors": {},
                                "notes": ["<j>"]}})
        _, page = self.drawn(folder)
        self.assertEqual({tag for tag, _ in page.tags} &
                         {"b", "i", "u", "script", "scene", "c", "e", "f", "g", "h", "j"}, set())
        self.assertEqual([attributes for _, attributes in page.tags if "onload" in attributes], [])
        for words in ("<u>Take</u> this & go.", "<script>alert(1)</script>", "<c>&d", "study <e>", "<f>", "<g>", "<h>",
                      "<j>",
                      '"x" onload="y', "$a_1$ $b", "# of $ & $: <b>Q1C1</b>",
                      r"""ixos 'my <scene>.xml' \ --set "A/B=\"\$x\`\" \\" \ --set "C=<1>" """):
            self.assertIn(words.strip(), page.text)
        self.assertIn("<title>&lt;b&gt;&amp;</title>", page.source)
        svg = (folder / "work-precision-force.svg").read_text()
        for word in ("&lt;b&gt;&amp;", "$a_1$ $b", "_under", "labels: _step", "x, y z"):
            self.assertIn(word, svg)

    def test_commands_are_quoted(self):
        self.assertEqual(command("a.xml", []), "ixos a.xml")
        self.assertEqual(command("a b.xml", ["A/B's C=1"]), "ixos 'a b.xml' \\\n    --set \"A/B's C=1\"")

    def test_places_of_the_runs(self):
        style.use_style()
        folder = self.changed("places", lambda rows: [
            rows[0].update(status="failed", wall_seconds="0", error_force="5"), rows[1].update(status="interrupted"),
            rows[2].update(status="stopped", error_force="0.02"), rows[4].update(error_force="1e-18"),
            rows[5].update(error_force="0.3")],
            pareto={"error_force": []}, recommendation={"run": None, "settings": [], "sentence": ""})
        found = Study(folder)
        figure = study.draw(found, "error_force")
        axes, failed = figure.axes
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        newmark, alpha = [line for line in axes.lines if len(line.get_xdata()) == 3]
        self.assertNotEqual((newmark.get_color(), newmark.get_marker()), (alpha.get_color(), alpha.get_marker()))
        cost = [run["wall_seconds"] for run in found.runs.values()]
        # Neither failed nor interrupted runs have a point; a failed one stands above, one without cost at the left.
        np.testing.assert_equal(newmark.get_ydata(), [math.nan, math.nan, 0.02])
        np.testing.assert_allclose(newmark.get_xdata()[2], cost[2])
        self.assertEqual([(len(line.get_xdata()), line.get_color()) for line in failed.lines],
                         [(1, newmark.get_color()), (1, alpha.get_color())])
        self.assertAlmostEqual(failed.lines[0].get_xdata()[0], axes.get_xlim()[0])
        np.testing.assert_allclose(failed.lines[1].get_xdata(), cost[3:4])
        np.testing.assert_equal(alpha.get_ydata(), [math.nan, axes.get_ylim()[0], 0.3])
        tolerance, = [line for line in axes.lines if list(line.get_ydata()) == [0.01, 0.01]]
        self.assertEqual(list(tolerance.get_xdata()), [0, 1])
        self.assertTrue(axes.get_ylim()[0] < 0.01 < 0.3 < axes.get_ylim()[1])
        self.assertIn("0.1", [text.get_text() for text in axes.texts])
        study.plt.close(figure)

    def test_lines_are_told_apart(self):
        for folder, count, words in (
                (self.strip, 12, ["scheme", *SCHEMES, "element", *ELEMENTS]),
                (make(self.folder / "schemes", elements=["Q1C4"]), 6, ["scheme", *SCHEMES]),
                (make(self.folder / "one", SCHEMES[3:4], ["Q1C4"]), 1, [])):
            shown, legend = study.looks(Study(folder))
            self.assertEqual(len({json.dumps(look, sort_keys=True) for look in shown.values()}), count)
            self.assertEqual([text for text, _ in legend], words)
        many = [study.look(number, stroke) for number in range(20) for stroke in range(4)]
        self.assertEqual(len({json.dumps(look, sort_keys=True) for look in many}), 80)

    def test_a_study_without_lines(self):
        folder = make(self.folder / "points", SCHEMES, ["Q1C4"], ["0.1"])
        data = json.loads((folder / "study.json").read_text())
        self.drawn(folder)
        self.assertNotIn("labels:", (folder / "work-precision-force.svg").read_text())
        write_data(folder, {**data, "connect": None, "tolerance": None, "measure": None, "reference": None,
                            "cost": "newton_iterations"})
        written, page = self.drawn(folder)
        self.assertEqual(len(written), 9)
        self.assertIn("Newton iterations", (folder / "work-precision-energy.svg").read_text())
        self.assertEqual(page.table("scheme", "status")[0], ["Newmark", "✗ diverged; at time 31.25"])

    def test_runs_that_are_not_there_yet(self):
        folder = self.changed("partial", lambda rows: rows.pop(4), pareto={},
                              recommendation={"run": None, "settings": [], "sentence": "It is not complete."})
        _, page = self.drawn(folder)
        self.assertEqual(page.table("scheme", *STEPS[:3])[1][2], "– no run")

    def test_all_runs_failed(self):
        folder = make(self.folder / "failed", SCHEMES[:2], largest=[0] * 6)
        (folder / "work-precision-force.png").write_text("of an earlier state")
        written, page = self.drawn(folder)
        self.assertEqual(written, ["report.html"])
        self.assertFalse((folder / "work-precision-force.png").exists())
        for words in ("No run reached the end.", "There is no plot", "20 runs: 20 diverged", "None: no run"):
            self.assertIn(words, page.text)
        self.assertEqual({row[4] for row in page.table("run", "scheme", "element", "time step")}, {"✗ diverged"})
        self.assertNotIn("--set", page.text)

    def test_what_is_wrong_is_named(self):
        number = itertools.count()

        def refused(expected, change_rows=None, **data):
            with self.assertRaises(ResultsError) as caught:
                Study(self.changed(f"wrong{next(number)}", change_rows, **data))
            self.assertIn(expected, str(caught.exception))

        for name in ("error_force", "status", "time step", "peak_memory_bytes", "run"):
            refused(f"study.csv has no column '{name}'", lambda rows, name=name: [row.pop(name) for row in rows])
        refused("could not convert string to float: 'fast'", lambda rows: rows[2].update(wall_seconds="fast"))
        refused("has the unknown status 'lost'", lambda rows: rows[2].update(status="lost"))
        refused("has the unknown scheme 'Other'", lambda rows: rows[2].update(scheme="Other"))
        refused("repeats the name or the settings of an earlier run",
                lambda rows: rows.append({**rows[0], "run": "again"}))
        refused("repeats the name or the settings of an earlier run", lambda rows: rows[1].update(run=rows[0]["run"]))
        refused("unknown connect 'dt' (known: scheme, element, time step)", connect="dt")
        refused("unknown cost 'money'", cost="money")
        refused("unknown measure 'error_x'", measure="error_x")
        refused("the tolerance -1 is not a number greater than 0", tolerance=-1)
        refused("the entry 'name' has the wrong type", name=3)
        refused("the entry 'common' has the wrong type", common=[3])
        refused("the entry 'pareto' has the wrong type", pareto={"error_force": [3]})
        refused("study.json has no entry 'reference/folder'", reference={"description": ""})
        judged = {"description": "", "folder": "", "judgement": "", "notes": []}
        refused("the entry 'reference/own_errors' has the wrong type", reference={**judged, "own_errors": {"a": "b"}})
        refused("study.json has no entry 'reference/own_errors'", reference=judged)
        refused("it names the run 'x', which study.csv does not have", pareto={"error_force": ["x"]})
        refused("it names the run 'x', which study.csv does not have",
                recommendation={"run": "x", "settings": [], "sentence": ""})
        folder = self.changed("damaged")
        text = (folder / "study.csv").read_text()
        for content, expected in ((text.splitlines()[0], "study.csv has no rows"), ("", "no column 'run'"),
                                  (text.replace("rejected_steps", "steps"), "study.csv has two columns 'steps'"),
                                  (text + "a,b\n", "run 'a' has 2 cells"), (text + '"a', "unexpected end of data")):
            (folder / "study.csv").write_text(content)
            with self.assertRaises(ResultsError) as caught:
                Study(folder)
            self.assertIn(expected, str(caught.exception))

    def test_what_is_wrong_is_said_on_one_line(self):
        folder = self.changed("columns", lambda rows: [row.pop("error_force") for row in rows])
        self.assert_refused(f"{folder}/study.csv has no column 'error_force'", "study.py", folder)
        self.assertEqual(len(list(folder.iterdir())), 2)
        (folder / "study.csv").write_bytes(b"run\xff")
        self.assert_refused("can't decode", "study.py", folder)
        (folder / "study.csv").unlink()
        self.assert_refused("does not exist", "study.py", folder)
        for content, expected in (("{", "study.json: Expecting"), ("[]", "the content has the wrong type"),
                                  ("{}", "study.json has no entry 'name'")):
            (folder / "study.json").write_text(content)
            self.assert_refused(expected, "study.py", folder)
        (folder / "study.json").unlink()
        self.assert_refused("does not exist", "study.py", folder)
        self.assert_refused("the folder", "study.py", self.folder / "none")
        self.assert_refused("unrecognized", "study.py", folder, "--wrong")
        self.assert_refused("FOLDER", "study.py")
        folder = self.changed("blocked")
        (folder / "report.html").mkdir()
        done = script("study.py", folder)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
        self.assertIn("report.html cannot be written", done.stderr)


class ScanTest(ScriptTest):
    def test_labels_have_units(self):
        folder = self.folder / "scan"
        (folder / "runs/2_7").mkdir(parents=True)
        (folder / "runs/2_7/summary.json").write_text(
            json.dumps({"units": {"force": {"symbol": "E0 L0^2"}, "time": {"symbol": "T0"}}}))
        quantities = ["peak reaction_top_y", "time of peak min_gap", "restitution a_vy"]
        (folder / "scan.json").write_text(json.dumps({
            "varied": [{"name": "Strength", "unit": "E0", "logarithmic": True, "values": ["1", "2"]},
                       {"name": "Way", "unit": "L0", "logarithmic": False, "values": ["7"]}],
            "quantities": quantities, "unit_columns": ["reaction_top_y", "time", ""]}))
        rows = [["run", "Strength", "Way", *quantities], ["1_7", "1", "7", "", "", ""], ["2_7", "2", "7", 3, 4, 5]]
        with open(folder / "scan.csv", "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(rows)
        self.assertEqual(self.draw("scan.py", folder), [folder / "scan.png", folder / "scan.svg"])
        svg = (folder / "scan.svg").read_text()
        for words in ("Strength [E₀]", "peak reaction_top_y [E₀ L₀²]", "time of peak min_gap [T₀]",
                      ">restitution a_vy<", "Way 7 [L₀]"):
            self.assertIn(words, svg)
        with open(folder / "scan.csv", "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(row[1:] for row in rows)
        self.assert_refused("'run'", "scan.py", folder)


if __name__ == "__main__":
    unittest.main()
