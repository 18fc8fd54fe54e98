"""The include directives of the library's files."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIB = ROOT / "lib"
STABLE = re.compile(r"Stable: ([^.]*)\.")
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def list_files(*endings):
    """Returns the files of lib with one of these endings, as paths relative to lib, in order."""
    return sorted(str(path.relative_to(LIB)) for path in LIB.rglob("*") if path.suffix in endings)


def read_includes(file):
    """Returns a tuple for each include directive of a file of lib: line, included path, whether it is in quotes."""
    found = []
    with open(LIB / file, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            if match := INCLUDE.match(line):
                found.append((number, match[2], match[1] == '"'))
    return found


def read_stable_names(header):
    """Returns the names that a stable header's comment lists."""
    lines = (LIB / header).read_text(encoding="utf-8").splitlines()
    comment = " ".join(line.removeprefix("///").strip() for line in lines if line.startswith("///"))
    match = STABLE.search(comment)
    return [name.strip() for name in match[1].split(",")] if match else []


def is_header_of_lib(included):
    """Returns whether an included path names a header of lib."""
    return (LIB / included).is_file()


def collect_headers(file):
    """Returns the file itself and all headers of lib that it includes, directly or through others.

    Each comes with the file that includes it first; the file itself comes with None.
    """
    found, waiting = {file: None}, [file]
    while waiting:
        including = waiting.pop()
        for _, included, _ in read_includes(including):
            if included not in found and is_header_of_lib(included):
                found[included] = including
                waiting.append(included)
    return found
