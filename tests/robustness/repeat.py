#!/usr/bin/python3
"""Runs scenes on two ranks twice and compares the runs byte by byte.

    tests/robustness/repeat.py [--driver build/release/drivers/ixos] [--only MueLu]

history.csv but for wall-clock seconds, and every byte of the fields, must be alike: sums over ranks and messages come in
one order, and no solver chooses by the clock. MUMPS on several ranks is left out: it repeats up to rounding only. The
exit status is 1 where anything differs.
"""
import argparse
import os
import subprocess
import sys
import tempfile

from kill_restart import ENVIRONMENT, ROOT, STEPS, driver_command, fields, history, scenarios


def short(settings):
    """A few hundred steps are enough to show a difference in the last digit."""
    end = {STEPS + "Final Time=2": "0.4", STEPS + "Final Time=10": "3"}
    return [STEPS + "Final Time=" + end[s] if s in end else s for s in settings]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--driver", default=os.path.join(ROOT, "build/release/drivers/ixos"))
    parser.add_argument("--only", default="", help="scenarios whose name has this in it")
    options = parser.parse_args()
    differ = 0
    chosen = [s for s in scenarios() if s[3] == 2 and options.only in s[0]]
    if not chosen:
        sys.exit(f"no scenario has \"{options.only}\" in its name")
    for name, scene, settings, ranks in chosen:
        with tempfile.TemporaryDirectory() as folder:
            runs = []
            for turn in ("first", "second"):
                output = os.path.join(folder, turn)
                subprocess.run(driver_command(options.driver, os.path.join(ROOT, "xml", scene + ".xml"),
                                              ["--output", output], short(settings), ranks), env=ENVIRONMENT, check=True)
                runs.append((history(output), fields(output)))
        if len(runs[0][0]) < 5 or not runs[0][1]:
            sys.exit(f"{name}: too little to compare")
        same = runs[0] == runs[1]
        differ += not same
        print(f"{name}: {len(runs[0][0])} rows, {'alike' if same else 'DIFFERENT'}", flush=True)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
