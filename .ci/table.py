"""The slices of continuous integration: each takes at most LIMIT minutes on two cores, from a finished release build.

.ci/run runs one of them after its main job. Their order is that of their turns: neighbours check different things.
Their number is prime, so that none is passed over where changes come by the same number of commits.
"""
from typing import NamedTuple

LIMIT = 40  # minutes of a slice


class Slice(NamedTuple):
    """A name, a sentence, and a command of bash in the root of the checkout. Its exit status is 77 if it cannot run."""
    name: str
    what: str
    command: str


# Long tests that are not named here are in the third part.
RESTARTS = r"^scene\.all_restarts$"
EXTREMES = r"^(extremes\..*|structure\.headers)$"

SLICES = (
    Slice("long-1", "long tests: restarts of all scenes",
          f"IXOS_LONG=1 tests/run.sh -L long -R '{RESTARTS}'"),
    Slice("sanitizers-1", "unit tests with a part under AddressSanitizer and UBSan: kernels in headers",
          "tests/sanitizers/run.sh headers"),
    Slice("packages", "Debian packages: build, lintian, debian/tests in a clean root",
          "IXOS_FASTER_ARCHS= tests/packages/run.sh build/packages"),
    Slice("tidy-1", "clang-tidy on a third of the sources",
          "tests/check_tidy.py build/release --part 1/3"),
    Slice("sanitizers-2", "unit tests with a part under AddressSanitizer and UBSan: meshes, laws, terms, models",
          "tests/sanitizers/run.sh bodies"),
    Slice("long-2", "long tests: kills, faults, other extremes; headers alone",
          f"IXOS_LONG=1 tests/run.sh -L long -R '{EXTREMES}'"),
    Slice("benchmarks", "benchmarks, compiled and run once",
          "tests/bench/short.py build/release"),
    Slice("debian-13-units", "Debian 13: build and quick unit tests",
          "tests/distributions/run.sh trixie --part units"),
    Slice("fuzzing", "a minute of fuzzing for each reader",
          "tests/fuzz/run.sh --seconds 60"),
    Slice("figures", "each measured table of the documents, in a short form",
          "docs/measure --all --trial"),
    Slice("sanitizers-3", "unit tests with a part under AddressSanitizer and UBSan: solvers, schemes, runs",
          "tests/sanitizers/run.sh steps"),
    Slice("reproducible", "Debian packages: two builds, equal to the bit",
          "tests/packages/run.sh --twice build/packages"),
    Slice("tidy-2", "clang-tidy on another third of the sources",
          "tests/check_tidy.py build/release --part 2/3"),
    Slice("sanitizers-4", "unit tests with a part under AddressSanitizer and UBSan: scenes, files, studies",
          "tests/sanitizers/run.sh scenes"),
    Slice("long-3", "all other long tests",
          f"IXOS_LONG=1 tests/run.sh -L long -E '{RESTARTS}|{EXTREMES}'"),
    Slice("readme", "commands of the README and of two tutorials in a clean root of Debian 12",
          "tests/readme/run.sh build/readme"),
    Slice("debian-13-others", "Debian 13: build and all other quick tests",
          "tests/distributions/run.sh trixie --part others"),
    Slice("tidy-3", "clang-tidy on the last third of the sources",
          "tests/check_tidy.py build/release --part 3/3"),
    Slice("debian-13-packages", "Debian 13: packages, debian/tests",
          "IXOS_FASTER_ARCHS= tests/distributions/run.sh trixie --only packages"),
)


def slice_of(commits):
    """Returns the slice whose turn it is after so many commits."""
    return SLICES[commits % len(SLICES)]
