#!/usr/bin/python3
"""Verifies with ixos --verify-restart that the scenes and studies of xml/, in their short forms, resume bit for bit.

    IXOS_DRIVER=build/release/drivers/ixos tests/scenes/restarts_test.py [--all] [NAME]

NAME takes the forms whose names have it in them. The short forms are those of tests/compare/forms.py; a file of xml/
without one is an error. The script takes the first form of each scene, three forms on two ranks, one with a double
integral, and the last run of each study. With --all it takes every form with every scheme, and every run of every
study. ixos-study must stand beside ixos.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/compare"), str(ROOT / "tests/support")]
from driver_process import ENVIRONMENT  # noqa: E402
from forms import STUDIES, XML, forgotten_files, scene_forms, write_short_study  # noqa: E402

DRIVER = os.environ.get("IXOS_DRIVER", str(ROOT / "build/release/drivers/ixos"))
KILLS = 2
ALSO = "ball, two ranks", "strip, two ranks", "two-balls, friction, two ranks", "two-balls, Double Integral"


def output(*command):
    return subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, check=True).stdout


def scene_runs(every):
    """Yields name, scene, settings and ranks of forms of scenes."""
    schemes = re.findall(r"^\S.*", output(DRIVER, "--list-schemes"), re.MULTILINE)
    scenes = set()
    for name, scene, settings, *ranks in scene_forms(schemes if every else ["Average Vector Field"]):
        if every or scene not in scenes or name in ALSO:
            yield name, scene, settings, ranks[0] if ranks else 1
        scenes.add(scene)


def study_runs(every):
    """Yields the same of runs of studies."""
    with tempfile.TemporaryDirectory() as folder:
        for study, short in STUDIES.items():
            path = write_short_study(study, short, pathlib.Path(folder))
            scene = re.search(r'name="Scene" type="string" value="(.*)\.xml"', path.read_text(encoding="utf-8"))[1]
            runs = output(DRIVER + "-study", path, "--list").splitlines()
            for run in runs if every else runs[-1:]:
                name, settings = run.split(": ", 1)
                yield f"{study}, {name}", scene, settings.split("; "), 1


def verify(scene, settings, ranks):
    """Returns whether the check succeeded, and what it printed."""
    command = [DRIVER, str(XML / (scene + ".xml")), "--verify-restart", "--kills", str(KILLS), "--ranks", str(ranks)]
    for setting in settings:
        command += ["--set", setting]
    with tempfile.TemporaryDirectory(prefix="ixos-restarts-") as folder:
        run = subprocess.run(command, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    return run.returncode == 0 and run.stdout.count("the same") == KILLS + 1, run.stdout + run.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true", help="verify every form and every run of the studies")
    parser.add_argument("name", nargs="?", default="", help="a part of the names of forms to verify")
    options = parser.parse_args()
    if forgotten_files():
        sys.exit(f"no short form in tests/compare/forms.py of: {', '.join(forgotten_files())}")
    runs = [run for run in (*scene_runs(options.all), *study_runs(options.all)) if options.name in run[0]]
    if not runs:
        sys.exit(f"no form has \"{options.name}\" in its name")
    failed = False
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for (name, *_), (good, said) in zip(runs, pool.map(lambda run: verify(*run[1:]), runs)):
            print(f"{name}: {'verified' if good else 'FAILED'}\n" + ("" if good else said), end="", flush=True)
            failed = failed or not good
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
