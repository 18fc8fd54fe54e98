#!/usr/bin/python3
"""Checks the manual pages and the completion in bash against the programs that they describe.

    IXOS_DRIVER=... IXOS_STUDY_DRIVER=... tests/manual/manual_test.py MANUAL

MANUAL is the folder that the build makes, with man1 and completions. A page that was not made, because help2man or
matplotlib is missing, is skipped; the exit status is 77 then, a skipped test.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build/release/manual")
PROGRAMS = {"ixos": os.environ.get("IXOS_DRIVER", "ixos"),
            "ixos-study": os.environ.get("IXOS_STUDY_DRIVER", "ixos-study"),
            "ixos-plot": str(ROOT / "drivers/plot/overview.py")}


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def options(program):
    """Returns the long options that the help of a program lists, one at the beginning of each entry."""
    return sorted(set(re.findall(r"^ +(?:-h, ?)?(--[a-z][a-z-]*)", output(PROGRAMS[program], "--help"), re.MULTILINE)))


def completions(program, line):
    """Returns what bash would offer at the end of a command line, with the words as bash separates them."""
    script = ROOT / "drivers/plot/completion.bash" if program == "ixos-plot" else MANUAL / "completions" / program
    words = [word for word in re.findall(r'"[^"]*"?|=|(?:\\.|[^\s="])+', line)] + ([""] if line.endswith(" ") else [])
    function = "_" + program.replace("-", "_")
    text = (f"compopt() {{ :; }}; source {script}; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); {function}; "
            "printf '%s\\n' \"${COMPREPLY[@]}\"")
    words[0] = PROGRAMS[program]
    return sorted(filter(None, output("bash", "-c", text, "bash", *words).splitlines()))


class PageTest(unittest.TestCase):
    def page(self, program):
        path = MANUAL / "man1" / (program + ".1")
        if not path.exists():
            self.skipTest(f"{path} was not made")
        return path

    def check(self, program, words):
        path = self.page(program)
        text = path.read_text(encoding="utf-8").replace("\\-", "-")
        listed = options(program)
        self.assertGreater(len(listed), 2)
        for option in listed:
            self.assertRegex(text, re.escape(option) + r"\b", "not in the page")
        for word in words:
            self.assertIn(word, text)
        if shutil.which("man"):
            shown = subprocess.run(["man", "--warnings", "-l", "-Tutf8", "-Z", path], capture_output=True, text=True,
                                   check=True, env=dict(os.environ, MANROFFSEQ="", MANWIDTH="80", LC_ALL="C.UTF-8"))
            self.assertEqual(shown.stderr, "")

    def test_ixos(self):
        self.check("ixos", ["ixos - simulate dynamic adhesion", "SYNOPSIS", "EXIT STATUS", "history.csv", "EXAMPLES"])

    def test_ixos_study(self):
        self.check("ixos-study", ["SYNOPSIS", "EXIT STATUS", "study.csv", "EXAMPLES"])

    def test_ixos_plot(self):
        self.check("ixos-plot", ["SYNOPSIS", "RESULTS", "SH OPTIONS", "EXAMPLES", "SEE ALSO"])


class CompletionTest(unittest.TestCase):
    def test_each_option(self):
        for program in ("ixos", "ixos-study"):
            self.assertEqual(completions(program, program + " --"), options(program))
        self.assertEqual(completions("ixos", "ixos --kill"), ["--kill-steps", "--kills"])
        self.assertNotIn("--kill-after-step", completions("ixos", "ixos --kill"))

    def test_options_of_ixos_plot(self):
        try:
            listed = options("ixos-plot")
        except subprocess.CalledProcessError:
            self.skipTest("ixos-plot needs matplotlib")
        self.assertLessEqual(set(listed), set(completions("ixos-plot", "ixos-plot --")))

    def test_scenes_and_folders(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("strip.xml", "strip.e"):
                pathlib.Path(folder, name).touch()
            pathlib.Path(folder, "strip.results").mkdir()
            start = f"{folder}/strip"
            both = [start + ".results", start + ".xml"]
            self.assertEqual(completions("ixos", "ixos " + start), both)
            self.assertEqual(completions("ixos", "ixos --output " + start), [start + ".results"])
            self.assertEqual(completions("ixos", "ixos --write-mesh " + start),
                             [start + ".e", start + ".results", start + ".xml"])
            self.assertEqual(completions("ixos-study", "ixos-study " + start), both)
        self.assertEqual(completions("ixos", "ixos --template "), ["ball", "block"])
        self.assertEqual(completions("ixos", "ixos --kills "), [])

    def test_each_scheme(self):
        listed = output(PROGRAMS["ixos"], "--list-schemes").splitlines()
        schemes = [line for line in listed if line and not line.startswith(" ")]
        offered = completions("ixos", 'ixos x.xml --set "Time Integrator/Type=')
        start = "Time Integrator/Type="
        self.assertEqual(offered, sorted([start + scheme for scheme in schemes] + [start + "Custom"]))

    def test_each_parameter(self):
        script = MANUAL / "completions/ixos"
        names = {line.split("=")[0] for line in
                 output("bash", "-c", f"source {script}; printf '%s' \"$_ixos_lines\"").splitlines()}
        path, found = "", 0
        for line in output(PROGRAMS["ixos"], "--parameters").splitlines():
            if line.startswith("## "):
                path = line[3:].replace(" / ", "/").replace("`", "")
            elif line.startswith("| ") and not line.startswith("| parameter |"):
                self.assertIn(f"{path}/{line.split('|')[1].strip()}", names)
                found += 1
        self.assertGreater(found, 150)

    def test_settings_level_by_level(self):
        for line, inserted in (
                ('ixos x.xml --set "Ti', "Time Integrator/"),
                ('ixos x.xml --set "Time Integrator/Ty', "Time Integrator/Type="),
                ('ixos x.xml --set "Materials/A/You', "Materials/A/Young's Modulus="),
                # Outside quotes: spaces are escaped, and bash has separated the word at "=".
                ("ixos x.xml --set Time\\ Integrator/Ty", "Time\\ Integrator/Type=")):
            self.assertEqual(os.path.commonprefix(completions("ixos", line)), inserted, line)
        for line, offered in (
                ('ixos x.xml --set "Interactions/W/Gamma', ["Interactions/W/Gamma L=", "Interactions/W/Gamma W="]),
                ('ixos x.xml --set "Materials/A/Plane', []),
                ('ixos x.xml --set "Materials/', ["Materials/", "Materials/<name>"]),
                ("ixos x.xml --set=Materials/", ["Materials/", "Materials/\\<name\\>"]),
                ("ixos x.xml --set 'Materials/A/You", ["Materials/A/You", "Materials/A/Young's Modulus="]),
                ('ixos x.xml --set "Output/Energies=', ["Output/Energies=false", "Output/Energies=true"]),
                ("ixos x.xml --set Time\\ Integrator/Type=Newm", ["Newmark"]),
                ("ixos x.xml --set Output/Energies=", ["false", "true"])):
            self.assertEqual(completions("ixos", line), offered, line)

    def test_shows_a_type_but_does_not_insert_it(self):
        start = "Time Integrator/Time Step Control/Final Time="
        for end in ("", "Fi", "Final Time="):
            line = 'ixos x.xml --set "Time Integrator/Time Step Control/' + end
            found = completions("ixos", line)
            if end:
                self.assertEqual(found, [start, start + "<double>"])
            else:
                self.assertIn(start, found)


if __name__ == "__main__":
    outcome = unittest.main(argv=sys.argv, exit=False).result
    sys.exit(1 if not outcome.wasSuccessful() else 77 if outcome.skipped else 0)  # 77: some were skipped
