#!/usr/bin/python3
"""Tests docs/measure and figures_test.py in a tree of their own, with a table of made-up times.

    tests/structure/measure_test.py

Exit status 77, a skipped test, if git is missing.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
from figures import runs  # noqa: E402  pylint: disable=wrong-import-position
from figures.table import Column  # noqa: E402  pylint: disable=wrong-import-position

COPIED = ["docs/measure", "docs/figures/*.py", "docs/figures/tables/__init__.py", "tests/support/driver_process.py",
          "tests/support/openmpi.env", "tests/compare/forms.py", "tests/structure/figures_test.py", "drivers/plot/*.py"]
CLOCKS = '''
from ..runs import interleaved
from ..table import Column, Table

def measure(context):
    samples = interleaved(["slow", "fast"], 3, lambda name: {"s": float(context.run_text("clock", name))})
    return [{"clock": name, "ratio": sample.ratio["s"], "s": sample.median["s"]} for name, sample in samples.items()]

COLUMNS = [Column("clock"), Column("to slow", "{:.2f}", "ratio"), Column("seconds", "{:.1f}", "s")]
TABLES = [Table("clocks", "docs/clocks.md", COLUMNS, measure, ("lib",))]
'''
PAGE = "# Clocks\n\n<!-- table clocks: docs/measure clocks -->\n<!-- end -->\n\nThe end.\n"
ROWS = ["| clock | to slow | seconds |", "| --- | --- | --- |", "| slow | 1.00 | 4.0 |", "| fast | 0.50 | 2.0 |"]


class Tree:
    """A tree with the scripts, a page with one table, a program that prints times, and a commit."""

    def __init__(self, folder):
        self.root = pathlib.Path(folder)
        for path in (path for pattern in COPIED for path in ROOT.glob(pattern)):
            copy = self.root / path.relative_to(ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, copy)
        self.write("docs/figures/tables/clocks.py", CLOCKS)
        self.write("docs/clocks.md", PAGE)
        self.write("lib/a.cpp", "int a;\n")
        self.write("build/tests/clock", '#!/bin/sh\n[ "$1" = slow ] && echo 4 || echo 2\n')
        self.write(".gitignore", "/build/\n")
        (self.root / "build/tests/clock").chmod(0o755)
        self.git("init", "-q")
        self.commit()

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, encoding="utf-8")

    def read(self, path="docs/clocks.md"):
        return (self.root / path).read_text(encoding="utf-8")

    def data(self):
        return json.loads(self.read("docs/results/data/clocks.json"))

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=A", "-c", "user.email=a@b", *words], cwd=self.root, check=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "A change")

    def call(self, script, *words):
        """Returns the exit status of a script, and all that it prints."""
        environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
        done = subprocess.run([sys.executable, self.root / script, *words], capture_output=True, text=True, check=False,
                              env=environment)
        return done.returncode, done.stdout + done.stderr

    def measure(self, *words):
        return self.call("docs/measure", "--build", str(self.root / "build"), "--no-build", *words)

    def check(self):
        return self.call("tests/structure/figures_test.py")


class FormatTest(unittest.TestCase):
    def test_cell(self):
        column = Column("to Newmark's", "{:.2f}", "ratio")
        for value, text in ((2 / 3, "0.67"), (3, "3.00"), (None, "-"), (float("nan"), "-"), ("exact", "exact")):
            self.assertEqual(column.cell({"ratio": value}), text)
        self.assertEqual(column.cell({}), "-")
        self.assertEqual(Column("scheme").key, "scheme")

    def test_ratios_are_those_within_a_repeat(self):
        times = {"base": iter([1, 10, 100]), "other": iter([2, 10, 300])}  # another load slows all of a repeat
        samples = runs.interleaved(times, 3, lambda name: {"s": next(times[name]), "none": None}, warm_up=False)
        self.assertEqual((samples["other"].ratio, samples["other"].median), ({"s": 2}, {"s": 10}))
        self.assertEqual(samples["base"].ratio, {"s": 1})

    def test_rows_that_a_program_prints(self):
        text = "Times:\n| a | b |\n|---|---|\n| 1 | x y |\n| 2 | - |\nthe end\n"
        self.assertEqual(runs.markdown_rows(text), [{"a": "1", "b": "x y"}, {"a": "2", "b": "-"}])


class MeasureTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
        self.addCleanup(folder.cleanup)
        self.tree = Tree(folder.name)

    def measured(self):
        """Measures the table, and commits it."""
        status, text = self.tree.measure("clocks")
        self.assertEqual(status, 0, text)
        self.tree.commit()

    def assert_refused(self, words, *expected):
        status, text = self.tree.measure(*words)
        self.assertEqual((status, len(text.splitlines())), (2, 1), text)
        for part in expected:
            self.assertIn(part, text)

    def assert_wrong(self, *expected):
        status, text = self.tree.check()
        self.assertEqual(status, 1, text)
        for part in expected:
            self.assertIn(part, text)

    def test_measures_a_table(self):
        self.measured()
        lines = self.tree.read().splitlines()
        self.assertEqual(lines[:8], ["# Clocks", "", "<!-- table clocks: docs/measure clocks -->", *ROWS, ""])
        self.assertRegex(lines[8], r"^\*Measured \d{4}-\d\d-\d\d at commit [0-9a-f]{7} on .*\.\*$")
        self.assertEqual(lines[9:], ["<!-- end -->", "", "The end."])
        data = self.tree.data()
        self.assertEqual(data["rows"], [{"clock": "slow", "ratio": 1, "s": 4}, {"clock": "fast", "ratio": 0.5, "s": 2}])
        self.assertEqual(data["programs"], ["build/release/tests/clock slow", "build/release/tests/clock fast"])
        self.assertEqual(self.tree.check()[0], 0)

    def test_measures_again(self):
        self.measured()
        page = self.tree.read()
        self.measured()
        self.assertEqual(len(page.splitlines()), len(self.tree.read().splitlines()))
        self.assertFalse(self.tree.data()["changes"])  # by the page and the data themselves

    def test_a_failure_changes_nothing(self):
        self.measured()
        page, data = self.tree.read(), self.tree.data()
        (self.tree.root / "build/tests/clock").write_text("#!/bin/sh\necho It stopped >&2\nexit 5\n", encoding="utf-8")
        status, text = self.tree.measure("clocks")
        self.assertEqual(status, 1)
        self.assertIn("exit status 5: build/release/tests/clock slow: It stopped", text)
        self.assertEqual((self.tree.read(), self.tree.data()), (page, data))

    def test_a_trial_replaces_no_measurement(self):
        self.assertEqual(self.tree.measure("--trial", "clocks")[0], 0)
        self.assertIn("*Not measured yet: a short trial", self.tree.read())
        self.assertIn("clocks: a short trial", self.tree.check()[1])
        page, data = self.tree.read(), self.tree.data()
        self.assertEqual(self.tree.measure("--trial", "--all")[0], 0)
        self.assertEqual((self.tree.read(), self.tree.data()), (page, data))
        self.measured()
        page = self.tree.read()
        self.assertEqual(self.tree.measure("--trial", "clocks")[0], 0)
        self.assertEqual(self.tree.read(), page)

    def test_refusals(self):
        self.assert_refused(["clock"], "there is no table clock", "clocks")
        self.assertEqual(self.tree.call("docs/measure", "clocks")[0], 2)  # there is no build
        self.tree.write("docs/clocks.md", "# Clocks\n")
        self.assert_refused(["clocks"], "docs/clocks.md has no place for the table clocks")

    def test_tells_what_the_code_has_changed_since(self):
        self.measured()
        self.tree.write("other/b.cpp", "int b;\n")
        self.tree.commit()
        self.assertNotIn("changed since", self.tree.measure("--list")[1])
        self.tree.write("lib/a.cpp", "int c;\n")
        self.tree.commit()
        self.assertIn("code changed since", self.tree.measure()[1])
        status, text = self.tree.check()
        self.assertEqual(status, 0)
        self.assertIn("to be measured anew: clocks: code changed since", text)
        self.assertEqual(self.tree.measure("--stale")[0], 0)
        self.assertNotIn("to be measured anew", self.tree.check()[1])

    def test_the_module_and_the_scenes_of_a_table_are_code(self):
        self.tree.write("docs/figures/tables/clocks.py", CLOCKS.replace('"clock", name', '"clock", name, "xml/a.xml"'))
        self.tree.write("xml/a.xml", "<a/>\n")
        self.tree.commit()
        for path, text in (("docs/figures/tables/clocks.py", CLOCKS), ("xml/a.xml", "<b/>\n")):
            self.measured()
            self.assertNotIn("to be measured anew", self.tree.check()[1])
            old = self.tree.read(path)
            self.tree.write(path, text)
            self.tree.commit()
            self.assertIn("to be measured anew: clocks: code changed since", self.tree.check()[1])
            self.tree.write(path, old)
            self.tree.commit()

    def test_tells_of_changes_without_a_commit(self):
        self.tree.write("lib/a.cpp", "int c;\n")
        self.measured()
        self.assertIn(" with changes on ", self.tree.read())

    def test_a_number_by_hand_is_wrong(self):
        self.measured()
        page = self.tree.read()
        self.tree.write("docs/clocks.md", page.replace("0.50", "0.40"))
        self.assert_wrong("docs/clocks.md: the table clocks differs from its data")
        self.assertEqual(self.tree.measure("--render")[0], 0)
        self.assertEqual(self.tree.read(), page)

    def test_wrong_places(self):
        self.assert_wrong("the table clocks has no data: docs/measure clocks")
        self.measured()
        page = self.tree.read()
        for old, new, message in (("<!-- end -->", "", "the table clocks has no line <!-- end -->"),
                                  ("docs/measure clocks", "make", "the command of the table clocks must be"),
                                  ("<!-- table clocks", "<!-- table watches", "the command of the table watches"),
                                  ("# Clocks", PAGE, "the table clocks has two places"),
                                  ("<!--", "", "docs/clocks.md: it has no place for the table clocks")):
            self.tree.write("docs/clocks.md", page.replace(old, new))
            self.assert_wrong(message)
        self.tree.write("docs/clocks.md", page + PAGE.replace("clocks", "watches"))
        self.assert_wrong("there is no table watches")

    def test_wrong_tables(self):
        self.measured()
        for old, new, message in (('("lib",)', '("src",)', "depends on src, which does not exist"),
                                  ('("lib",)', '("lib",), minutes=6', "the table clocks takes 6 minutes"),
                                  ('"to slow"', '"x"', "the table clocks differs from its data"),
                                  ('"ratio")', '"share")', "the data of clocks have other columns"),
                                  ("docs/clocks.md", "README.md", "belongs to README.md")):
            self.tree.write("docs/figures/tables/clocks.py", CLOCKS.replace(old, new))
            self.assert_wrong(message)
        self.tree.write("docs/figures/tables/clocks.py", CLOCKS)
        self.tree.write("docs/results/data/watches.json", "{}")
        self.assert_wrong("docs/results/data/watches.json belongs to no table")


if __name__ == "__main__":
    if not shutil.which("git"):
        print("git is missing")
        sys.exit(77)
    unittest.main()
