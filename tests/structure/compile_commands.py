"""The commands that a build compiles its sources with."""
import json
import pathlib
import shlex
from typing import NamedTuple


class Command(NamedTuple):
    """A source, the words of its command, less those that only g++ knows, and the folder where the build runs it."""
    source: pathlib.Path
    words: list
    folder: str

    def after(self, option):
        """Returns the word after an option."""
        return self.words[self.words.index(option) + 1]

    def as_entry(self):
        """Returns the command as compile_commands.json has it."""
        return {"directory": self.folder, "command": shlex.join(self.words), "file": str(self.source)}


def for_any_compiler(words):
    """Returns the words less those that only g++ knows: precompiled headers, which can hide that a file does not include
    what it needs, and widths of copies."""
    kept = []
    for word in words:
        if word.endswith("/cmake_pch.hxx") and kept[-1:] == ["-include"]:
            kept.pop()
        elif not word.startswith(("-fpch-preprocess", "-Winvalid-pch", "-mmove-max=", "-mstore-max=")):
            kept.append(word)
    return kept


def read_commands(build):
    """Returns the commands of a build's compile_commands.json."""
    with open(pathlib.Path(build) / "compile_commands.json", encoding="utf-8") as file:
        return [Command((pathlib.Path(entry["directory"]) / entry["file"]).resolve(),
                        for_any_compiler(shlex.split(entry["command"])), entry["directory"])
                for entry in json.load(file)]
