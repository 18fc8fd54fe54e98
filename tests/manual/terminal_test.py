#!/usr/bin/python3
"""Types commands of ixos into a real bash, with the Tab key, and checks which arguments the command gets.

    tests/manual/terminal_test.py SCRIPT

SCRIPT is the completion of ixos. manual_test.py checks what bash offers; this test checks what becomes of it in a
terminal: bash's words, its quotes and what it inserts.
"""
import os
import pathlib
import pty
import select
import sys
import tempfile
import unittest

SCRIPT = str(pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build/release/manual/completions/ixos").resolve())
PROMPT, SECONDS = "PROMPT$ ", 20


class Terminal:
    """An interactive bash in a folder, where the command ixos writes its arguments to a file."""

    def __init__(self, folder):
        self.arguments = pathlib.Path(folder, "arguments")
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", PS1=PROMPT, HISTFILE="", INPUTRC="/dev/null")
            os.execvp("bash", ["bash", "--norc", "--noprofile", "-i"])
        self.read()
        self.enter(f"source '{SCRIPT}'; ixos() {{ printf '%s\\n' \"$@\" > {self.arguments}; }}")

    def read(self):
        """Reads up to the next prompt."""
        text = ""
        while not text.endswith(PROMPT):
            if not select.select([self.terminal], [], [], SECONDS)[0]:
                raise TimeoutError(text)
            text += os.read(self.terminal, 65536).decode()

    def enter(self, line):
        os.write(self.terminal, (line + "\n").encode())
        self.read()

    def words(self, line):
        """Returns the arguments that ixos gets when someone types the line."""
        self.enter(line)
        return self.arguments.read_text(encoding="utf-8").splitlines()

    def close(self):
        os.close(self.terminal)
        os.waitpid(self.pid, 0)


class TerminalTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name in ("strip.xml", "my scene.xml", "it's.xml", "strip.e"):
            pathlib.Path(folder.name, name).touch()
        pathlib.Path(folder.name, "strip results").mkdir()
        self.terminal = Terminal(folder.name)
        self.addCleanup(self.terminal.close)

    def check(self, expected, *lines):
        for line in lines:
            self.assertEqual(self.terminal.words("ixos " + line), expected, line)

    def test_files(self):
        self.check(["my scene.xml"], "m\t", '"m\t', "'m\t", "my\\ s\t")
        self.check(["it's.xml"], "i\t", '"i\t')
        self.check(["strip.xml"], "strip.\t")
        self.check(["--output", "strip results/"], "--ou\tst\t", '--output "st\t')
        self.check(["--output=strip results/"], "--output=st\t")
        self.check(["strip.xml", "--write-mesh", "strip.e"], "strip.\t--wr\tstrip.e\t")

    def test_words(self):
        self.check(["--template", "block"], "--te\tbl\t")
        self.check(["strip.xml", "--verify-restart", "--kills", "2"], "strip.\t--verify\t--kills\t2")

    def test_settings_in_quotes(self):
        self.check(["--set", "Time Integrator/Type=Bathe Composite"], '--set "Ti\tTy\tBa\t', "--set 'Ti\tTy\tBa\t",
                   "--set Ti\tTy\tBa\t", "--set Time\\ Integrator/Type=Bathe\\ C\t")
        self.check(["--set=Output/Energies=true"], "--set=Outp\tEnergies=t\t", '--set="Outp\tEnergies=t\t')
        self.check(["--set", "Output/Energies=true", "--check"], '--set "Output/Ener\tt\t --ch\t')
        # Single quotes cannot hold an apostrophe: nothing is inserted.
        self.check(["--set", "Materials/Ball/Young's Modulus=3"], '--set "Mat\tBall/Yo\t3"', "--set Mat\tBall/Yo\t3")
        self.check(["--set", "Materials/Ball/Yo"], "--set 'Mat\tBall/Yo\t'")

    def test_names_and_types_are_not_inserted(self):
        self.check(["--set", "Materials/x"], '--set "Mat\t\tx"', "--set Mat\t\tx")
        self.check(["--set", "Time Integrator/Time Step Control/Final Time=3"],
                   '--set "Time Integrator/Time Step Control/Fin\t\t3"')


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
