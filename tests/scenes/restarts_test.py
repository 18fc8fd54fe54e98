#!/usr/bin/python3
"""Verifies with ixos --verify-restart that the scenes of xml/, in their short forms, resume bit for bit.

    IXOS_DRIVER=build/release/drivers/ixos tests/scenes/restarts_test.py [NAME]

NAME takes the forms whose names have it in them. Of each scene the first form of tests/compare/forms.py is taken, and
two forms on two ranks.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/compare"), str(ROOT / "tests/support")]
from driver_process import ENVIRONMENT  # noqa: E402
from forms import STUDIES, XML, scene_forms  # noqa: E402

DRIVER = os.environ.get("IXOS_DRIVER", str(ROOT / "build/release/drivers/ixos"))
KILLS = 2


def chosen_forms():
    """Returns the name, scene, settings and ranks of each form to verify."""
    forms, scenes = [], set()
    for name, scene, settings, *ranks in scene_forms(["Average Vector Field"]):
        if scene not in scenes or name in ("ball, two ranks", "strip, two ranks"):
            forms.append((name, scene, settings, ranks[0] if ranks else 1))
        scenes.add(scene)
    forgotten = {path.stem for path in XML.glob("*.xml")} - scenes - set(STUDIES)
    if forgotten:
        sys.exit(f"no form of {', '.join(sorted(forgotten))}")
    return forms


def verify(scene, settings, ranks, folder):
    """Returns whether the check succeeded, and what it printed."""
    command = [DRIVER, str(XML / (scene + ".xml")), "--verify-restart", "--kills", str(KILLS), "--ranks", str(ranks)]
    for setting in settings:
        command += ["--set", setting]
    run = subprocess.run(command, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    return run.returncode == 0 and run.stdout.count("the same") == KILLS + 1, run.stdout + run.stderr


def main():
    only = sys.argv[1] if len(sys.argv) > 1 else ""
    forms = [form for form in chosen_forms() if only in form[0]]
    if not forms:
        sys.exit(f"no form has \"{only}\" in its name")
    failed = False
    for name, scene, settings, ranks in forms:
        with tempfile.TemporaryDirectory(prefix="ixos-restarts-") as folder:
            good, output = verify(scene, settings, ranks, folder)
        print(f"{name}: {'verified' if good else 'FAILED'}\n" + ("" if good else output), end="", flush=True)
        failed = failed or not good
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
