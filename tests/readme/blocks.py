#!/usr/bin/python3
"""Lists the commands of README.md and of two tutorials, or runs them in order.

    tests/readme/blocks.py [--run PREFIX...]

Each command of a block of sh, and each block of python or xml is one: a new block needs no entry here. Of a tutorial it
is each indented line that begins with a program, as a reader would copy it. PREFIX are words
before each command, such as chroot and its folder: bash begins there in a checkout. A command that still runs at its
limit is ended; it passes if it has printed no error and is none of those that must end (LIMITS). The exit status is 1
if a command failed.
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
TUTORIALS = ("docs/tutorials/mushroom-pillar/mushroom-pillar.md", "docs/tutorials/scan-20/scan-20.md")
COPIED = re.compile(r"^ {4,6}((?:ixos|ixos-study|docs/\S+|drivers/\S+) (?:[^\n]*\\\n)*[^\n]*|docs/\S+)$", re.MULTILINE)
# As docs/tutorials/README.md says.
BUILT = "PATH=$PWD/build/release/drivers:$PATH PYTHONPATH=build/release/python "
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
COMMENT = re.compile(r"\s{2,}# .*$", re.MULTILINE)
ERROR = re.compile(r"^(ixos(-study)?: (?!warning: )|Traceback|.*\berror: )", re.MULTILINE)
LIMIT, LIMIT_OF_TUTORIALS = 60, 600  # seconds

# By language: the command of a block; None if it has none.
COMMANDS = {
    "sh": "{}",
    "python": "PYTHONPATH=build/release/python /usr/bin/python3 - <<'END'\n{}END",
    "xml": "cat > block.xml <<'END'\n{}END\ndrivers/run.sh block.xml",  # as the text below it says
    "cmake": None,  # tests/CMakeLists.txt has programs with these lines: embedding.*
}
# By command: why it is left out.
LEFT_OUT = {
    "apt build-dep ./ && dpkg-buildpackage -b -us -uc": "the slice packages does",
    "apt install ../ixos_*.deb ../python3-ixos_*.deb": "the slice packages does",
    "ixos /usr/share/ixos/xml/ball.xml": "debian/tests/ball does",
}
# By command: a shorter one. The main job of .ci/run builds and runs all tests; here it lists those that it would run.
SHORT = {"tests/run.sh": "targets='ixos_driver ixos_study ixos_python' tests/run.sh --show-only"}
# By command: seconds, where LIMIT is too short. These must end: they build Ixos, or later commands draw their results.
STRIP = 'drivers/run.sh xml/strip.xml --set "Output/Fields Time Interval=1"'
LIMITS = {"drivers/run.sh": 2000, "tests/run.sh": 900, STRIP: 400}


def split(text):
    """Returns the commands of a block of sh."""
    found, begun = [], ""
    for line in COMMENT.sub("", text).splitlines():
        begun += line + "\n"
        whole = subprocess.run(["bash", "-n"], input=begun, capture_output=True, text=True).returncode == 0
        if whole and not line.endswith("\\"):
            found.append(begun.strip())
            begun = ""
    return [command for command in found + [begun.strip()] if command]


def commands():
    """Returns the commands of README.md in order."""
    found = []
    for language, text in BLOCK.findall(README.read_text(encoding="utf-8")):
        command = COMMANDS.get(language)
        if command:
            found += split(text) if language == "sh" else [command.format(text)]
    return found


def copied():
    """Returns the commands of the tutorials, of each page in order."""
    return [BUILT + command for page in TUTORIALS for command in COPIED.findall((ROOT / page).read_text(encoding="utf-8"))]


def check():
    """Yields a message for each table of this file that does not fit README.md."""
    known = commands()
    for command in sorted(LEFT_OUT.keys() | SHORT.keys() | LIMITS.keys()):
        if command not in known:
            yield f"tests/readme/blocks.py: README.md does not have the command: {command}"
    for page in TUTORIALS:
        if not COPIED.search((ROOT / page).read_text(encoding="utf-8")):
            yield f"tests/readme/blocks.py: {page} has no command"
    for language in sorted({language for language, _ in BLOCK.findall(README.read_text(encoding="utf-8"))}):
        if language not in COMMANDS:
            yield f"tests/readme/blocks.py: say what to do with README.md's blocks of {language}"


def end(process):
    """Ends a process and its children."""
    for kind, seconds in ((signal.SIGTERM, 20), (signal.SIGKILL, None)):
        os.killpg(process.pid, kind)
        try:
            process.wait(seconds)
            return
        except subprocess.TimeoutExpired:
            pass


def limit(command):
    """Returns the seconds of a command. Those of tutorials must end: later ones draw their results."""
    return LIMITS.get(command, LIMIT_OF_TUTORIALS if command.startswith(BUILT) else LIMIT)


def run(command, prefix):
    """Runs a command. Returns why it failed, an empty string if it did not, and what it printed."""
    with tempfile.NamedTemporaryFile() as file:
        output = pathlib.Path(file.name)
        process = subprocess.Popen([*prefix, "bash", "-c", SHORT.get(command, command)], stdin=subprocess.DEVNULL,
                                   stdout=file, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            status = process.wait(limit(command))
            return f"exit status {status}" if status else "", output.read_text(errors="replace")
        except subprocess.TimeoutExpired:
            printed = output.read_text(errors="replace")  # before its end, of which programs complain
            end(process)
            print("   ended by its limit", flush=True)
            if limit(command) > LIMIT:
                return "not done within its limit", printed
            return "an error before its end" if ERROR.search(printed) else "", printed
        finally:  # this program may be ended, too, and the command has a session of its own
            if process.poll() is None:
                end(process)


def main():
    prefix = sys.argv[2:] if sys.argv[1:2] == ["--run"] else None
    if prefix is None and len(sys.argv) > 1:
        sys.exit(__doc__)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that run() ends its command
    failed = 0
    for command in commands() + copied():
        print(f"== {command}", flush=True)
        if command in LEFT_OUT:
            print(f"   left out: {LEFT_OUT[command]}", flush=True)
        elif prefix is not None:
            begin = time.monotonic()
            failure, printed = run(command, prefix)
            print(f"   {time.monotonic() - begin:.0f} s {failure}", flush=True)
            if failure:
                failed += 1
                print(printed[-3000:], flush=True)
        elif command in SHORT:
            print(f"   instead: {SHORT[command]}")
    problems = list(check())
    print("\n".join(problems + [f"{failed} commands failed"] * bool(failed)))
    return 1 if failed or problems else 0


if __name__ == "__main__":
    sys.exit(main())
