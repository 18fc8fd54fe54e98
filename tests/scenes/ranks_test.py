#!/usr/bin/python3
"""Runs the scenes of xml/ that dissipate, in short forms, on one and on two ranks and compares their histories (15 s).

    IXOS_DRIVER=build/release/drivers/ixos tests/scenes/ranks_test.py [NAME]

NAME takes the forms whose names have it in them. The short forms are those of tests/compare/forms.py.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / folder) for folder in ("tests/compare", "tests/support", "drivers/plot")]
from driver_process import ENVIRONMENT, driver_command  # noqa: E402
from forms import XML, scene_forms  # noqa: E402
from histories import differences  # noqa: E402
from result_files import read_history, read_summary  # noqa: E402

DRIVER = os.environ.get("IXOS_DRIVER", str(ROOT / "build/release/drivers/ixos"))
FORMS = {"film-peel, friction": "friction_of_Wall", "gecko-drag": "friction_of_Wall",
         "spring-block": "friction_of_Wall", "rate-peel": "viscoelasticity_of_body",
         "restitution, Maxwell branch": "viscoelasticity_of_body", "sphere-hysteresis": "viscoelasticity_of_body"}
BOUND = 1e-7  # of the largest value; 2e-11 was seen


def histories(scene, settings, folder):
    """Returns the columns of the runs on one and on two ranks."""
    tables = []
    for ranks in (1, 2):
        results = f"{folder}/{ranks}"
        subprocess.run(driver_command(DRIVER, str(XML / (scene + ".xml")), ["--output", results], settings, ranks),
                       env=ENVIRONMENT, check=True)
        if read_summary(pathlib.Path(results, "summary.json"))["ranks"] != ranks:
            raise RuntimeError(f"{scene}: the run has not {ranks} ranks: does mpirun fit the driver?")
        tables.append(read_history(pathlib.Path(results, "history.csv")))
    return tables


def main():
    part = sys.argv[1] if len(sys.argv) > 1 else ""
    forms = {name: (scene, settings) for name, scene, settings, *_ in scene_forms([])}
    failed = False
    for name, source in FORMS.items():
        if part not in name:
            continue
        with tempfile.TemporaryDirectory(prefix="ixos-ranks-") as folder:
            one, two = histories(*forms[name], folder)
        problems = list(differences(one, two, BOUND))
        if not one["dissipated_" + source][-1] > 0:
            problems.append("nothing is dissipated: the form is too short")
        print(f"{name}: {'; '.join(problems) or 'equal'}", flush=True)
        failed = failed or bool(problems)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
