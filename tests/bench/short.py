#!/usr/bin/python3
"""Compiles the benchmarks, and runs each once in a form that ends in seconds, so that none rots unseen.

    tests/bench/short.py BUILD_FOLDER [FILE...]

FILE is a file of tests/bench; default: all. The numbers mean nothing. The exit status is 1 if a run fails.
structure.ci checks that each file of tests/bench is named here.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIMIT = 600  # seconds of a run

# By file: the command. {build} is the build folder, {ixos} its driver, {folder} one for results.
RUNS = {
    "advice_cases.py": ("tests/bench/advice_cases.py", "--seed", "1", "--cases", "1", "--budget", "1", "--grid", "0",
                        "--reference", "5", "--output", "{folder}", "--drivers", "{build}/drivers"),
    "ball_pictures.sh": ("tests/bench/ball_pictures.sh", "{folder}/runs", "{folder}", "{ixos}", "--set",
                         "Time Integrator/Time Step Control/Final Time=0.5"),
    "contact_quadrature.cpp": ("{build}/tests/contact_quadrature", "xml/strip.xml", "1"),
    "error_over_time.py": ("tests/bench/error_over_time.py", "--output", "{folder}/picture.png"),
    "error_of_following.py": ("tests/bench/error_of_following.py", "--output", "{folder}/picture.png"),
    "error_over_unknowns.py": ("tests/bench/error_over_unknowns.py", "--output", "{folder}/picture.png"),
    "kernels_benchmark.cpp": ("{build}/tests/kernels_benchmark", "--benchmark_min_time=0.001"),
    "product_times.cpp": ("{build}/tests/product_times", "4", "2", "Hex8", "Hex27", "Tet10", "Tet15"),
    "python_overhead.py": ("tests/bench/python_overhead.py",),
    "spatula_pictures.sh": ("tests/bench/spatula_pictures.sh", "{folder}/runs", "{folder}", "{ixos}", "--set",
                            "Mesh/Spatula/Target Cells=300", "--set", "Materials/Keratin/Stiffness Damping=6"),
    "spectral_properties.cpp": ("{build}/tests/spectral_properties",),
    "static_solve.cpp": ("{build}/tests/static_solve", "4", "x1", "Hex8", "Hex27", "Tet10", "Tet15"),
    "strip_pictures.sh": ("tests/bench/strip_pictures.sh", "{folder}/runs", "{folder}", "{ixos}", "--set",
                          "Mesh/Box/Divisions={{80, 4}}", "--set", "Time Integrator/Time Step Control/Time Step=1"),
    "tie_times.cpp": ("{build}/tests/tie_times", "6", "2"),
}

# By file: why it has no run.
WITHOUT_RUN = {
    "advice_scenes.py": "advice_cases.py imports it",
    "block_cells.hpp": "product_times.cpp and static_solve.cpp include it",
    "message_counter.cpp": "docs/measure ranks-messages loads it",
    "pictures.sh": "the scripts *_pictures.sh source it",
    "spatula_damping.sh": "spatula_pictures.sh calls it",
}


def run(name, build, folder):
    """Runs the short form of a file. Returns whether it ended well, without a message of ixos."""
    words = {"build": build, "ixos": build / "drivers/ixos", "folder": folder}
    command = [word.format(**words) for word in RUNS[name]]
    if command[0].endswith(".py"):
        command.insert(0, "/usr/bin/python3")
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": str(build / "python"), "PYTHONDONTWRITEBYTECODE": "1",
                   "IXOS_DRIVER": str(build / "drivers/ixos")}
    begin = time.monotonic()
    try:
        done = subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", timeout=LIMIT)
        output = done.stdout
        if done.returncode != 0:
            failure = f"exit status {done.returncode}"
        else:  # scripts of many runs continue when one fails
            failure = "ixos failed" if re.search("^ixos(-study)?: ", output, re.MULTILINE) else ""
    except subprocess.TimeoutExpired as late:
        failure, output = f"it takes more than {LIMIT} s", (late.stdout or b"").decode(errors="replace")
    print(f"{time.monotonic() - begin:6.1f} s  {name}  {failure}", flush=True)
    if failure:
        print(" ".join(command) + "\n" + output[-2000:], flush=True)
    return not failure


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    names = sys.argv[2:] or sorted(RUNS)
    for name in names:
        if name not in RUNS:
            print(f"short.py: {name} has no short form: {WITHOUT_RUN.get(name, 'no such file')}", file=sys.stderr)
            sys.exit(2)
    subprocess.run(["cmake", "--build", build, "--target", "benchmarks", "ixos_driver"], check=True)
    failed = []
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            if not run(name, build, folder):
                failed.append(name)
    print(f"{len(names)} benchmarks ran" + (", of which failed: " + ", ".join(failed) if failed else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
