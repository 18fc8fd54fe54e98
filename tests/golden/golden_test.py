#!/usr/bin/python3
"""Runs the scenes that earlier versions ran, and resumes from the checkpoints that they wrote.

    IXOS_DRIVER=build/release/drivers/ixos tests/golden/golden_test.py [NAME]

NAME takes the scenes whose version/name has it in them, such as 0.2.0/strip. For each scene of tests/golden/VERSION:

- ixos --check accepts it, and it runs to its end.
- history.csv and summary.json have all names of VERSION/columns.txt. New ones may be there.
- If the scene writes checkpoints, it resumes from VERSION/SCENE.h5, which that version wrote half-way. The last row of
  history.csv is then that of the run that nobody disturbed, but for counts and clocks. Both runs are of this build, so
  no number of an earlier version is a reference.

tests/golden/make.sh writes the files beside the scenes. The exit status is 1 if a scene fails.
"""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

GOLDEN = pathlib.Path(__file__).resolve().parent
ROOT = GOLDEN.parents[1]
sys.path[:0] = [str(ROOT / folder) for folder in ("tests/compare", "tests/support", "drivers/plot")]
from driver_process import ENVIRONMENT  # noqa: E402
from histories import differences  # noqa: E402
from result_files import FileError, read_history  # noqa: E402
from result_names import read_names, result_names  # noqa: E402

DRIVER = os.environ.get("IXOS_DRIVER", str(ROOT / "build/release/drivers/ixos"))
BOUND = 1e-6  # of the largest value of a column; another build or solver resumes to the solver's tolerance


class Refused(Exception):
    """A command ended with another exit status than 0."""


def ixos(*arguments):
    """Runs ixos, and returns what it prints."""
    run = subprocess.run([DRIVER, *map(str, arguments)], env=ENVIRONMENT, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise Refused(f"ixos {' '.join(map(str, arguments[1:]))}: exit status {run.returncode}\n{run.stderr.rstrip()}")
    return run.stdout + run.stderr


def writes_checkpoints(scene):
    """Returns whether a scene states an interval between checkpoints."""
    return ElementTree.parse(scene).find(".//*[@name='Checkpoint']/*[@name='Interval']") is not None


def missing_names(scene, results):
    """Yields a message for each name that the scene's results no longer have."""
    now = result_names(results)
    for file, names in read_names(scene.parent / "columns.txt").get(scene.stem, {"columns.txt": [scene.stem]}).items():
        for name in names:
            if name not in now.get(file, []):
                yield f"{file} lacks {name}"


def problems(scene, folder):
    """Yields a message for each promise that is broken."""
    ixos(scene, "--check")
    ixos(scene, "--quiet", "--output", folder / "whole")
    yield from missing_names(scene, folder / "whole")
    if writes_checkpoints(scene):
        restart = ("--restart", scene.with_suffix(".h5"))
        if "Changed:" in ixos(scene, "--check", *restart):
            yield "the checkpoint counts as that of another scene"
        ixos(scene, "--quiet", "--output", folder / "resumed", *restart)
        whole, resumed = (read_history(folder / name / "history.csv") for name in ("whole", "resumed"))
        if not 0 < resumed["step"][0] < whole["step"][-1]:
            yield f"the run resumed at step {resumed['step'][0]:g}"
        yield from differences(whole, resumed, BOUND, rows=slice(-1, None))


def examine(scene):
    """Returns the messages on a scene."""
    messages = []
    with tempfile.TemporaryDirectory(prefix="ixos-golden-") as folder:
        try:
            for message in problems(scene, pathlib.Path(folder)):
                messages.append(message)
        except (Refused, FileError) as error:
            messages.append(str(error))
    return messages


def main():
    part = sys.argv[1] if len(sys.argv) > 1 else ""
    scenes = [scene for scene in sorted(GOLDEN.glob("*/*.xml")) if part in f"{scene.parent.name}/{scene.stem}"]
    if not scenes:
        sys.exit(f"no scene has \"{part}\" in its name")
    failed = False
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for scene, messages in zip(scenes, pool.map(examine, scenes)):
            print(f"{scene.parent.name}/{scene.stem}: {'; '.join(messages) or 'kept'}", flush=True)
            failed = failed or bool(messages)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
