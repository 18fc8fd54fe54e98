#!/usr/bin/python3
"""Checks that the stable headers, lib/ixos, are what docs/embedding.md says.

    tests/structure/stable_headers_test.py

- A stable header only includes headers of lib. Its comment lists the names that are stable after "Stable:". Each of
  them is declared in a header that it includes.
- The table of docs/embedding.md has a row for each stable header with the same names.
- No other file of lib includes a stable header.
- Example programs (docs/examples/programs) include stable headers only, and each is built by the CMakeLists.txt there.

The exit status is 1 if anything differs.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import INCLUDE, LIB, ROOT, is_header_of_lib, list_files, read_includes  # noqa: E402

GUIDE = "docs/embedding.md"
PROGRAMS = ROOT / "docs" / "examples" / "programs"
NAMES = re.compile(r"Stable: ([^.]*)\.")
ROW = re.compile(r"\|\s*`<(ixos/\w+\.hpp)>`\s*\|[^|]*\|([^|]*)\|\s*$", re.MULTILINE)


def read_names(header):
    """Returns the names that a stable header's comment lists."""
    lines = (LIB / header).read_text(encoding="utf-8").splitlines()
    comment = " ".join(line.removeprefix("///").strip() for line in lines if line.startswith("///"))
    match = NAMES.search(comment)
    return [name.strip() for name in match[1].split(",")] if match else []


def check_header(header):
    """Yields a message for each fault of one stable header."""
    place = f"lib/{header}"
    if header.count("/") != 1:
        yield f"{place}: stable headers stand in lib/ixos itself: move it there"
    included = [name for _, name, _ in read_includes(header)]
    for name in included:
        if not is_header_of_lib(name) or name.startswith("ixos/"):
            yield f"{place}: a stable header only includes other headers of lib: remove {name}"
    names = read_names(header)
    if not names:
        yield f"{place}: its comment has no list \"Stable: ...\": add the stable names"
    text = "\n".join((LIB / name).read_text(encoding="utf-8") for name in included if is_header_of_lib(name))
    code = re.sub(r"//.*", "", text)
    for name in names:
        if not re.search(rf"\b{re.escape(name)}\b", code):
            yield f"{place}: no header that it includes declares {name}: include the one that does, or remove the name"


def check_guide(headers):
    """Yields a message for each stable header whose row in the guide is missing or differs."""
    rows = dict(ROW.findall((ROOT / GUIDE).read_text(encoding="utf-8")))
    for header in headers:
        if header not in rows:
            yield f"{GUIDE}: the table has no row for `<{header}>`: add one"
            continue
        told = set(re.findall(r"`(\w+)`", rows[header]))
        for name in sorted(told ^ set(read_names(header))):
            yield f"{GUIDE}: {name} is stable in either the row of `<{header}>` or lib/{header}, not in both"
    for header in sorted(set(rows) - set(headers)):
        yield f"{GUIDE}: lib/{header} does not exist: delete its row"


def check_programs():
    """Yields a message for each example program that includes an internal header or is not built."""
    built = (PROGRAMS / "CMakeLists.txt").read_text(encoding="utf-8")
    for program in sorted(PROGRAMS.glob("*.cpp")):
        if not re.search(rf"\b{program.stem}\b", built):
            yield f"{program.relative_to(ROOT)}: CMakeLists.txt beside it does not build it: add it there"
        for number, line in enumerate(program.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if match and (is_header_of_lib(match[2]) or "internal" in match[2]) and not match[2].startswith("ixos/"):
                yield f"{program.relative_to(ROOT)}:{number}: {match[2]} is internal: include a stable header, <ixos/...>"
            if match and match[2].startswith("ixos/") and not is_header_of_lib(match[2]):
                yield f"{program.relative_to(ROOT)}:{number}: lib/{match[2]} does not exist"


def main():
    headers = [file for file in list_files(".hpp") if file.startswith("ixos/")]
    problems = [problem for header in headers for problem in check_header(header)]
    problems += check_guide(headers)
    problems += check_programs()
    for file in list_files(".hpp", ".cpp"):
        problems += [f"lib/{file}:{line}: include the header that {included} includes, not this one"
                     for line, included, _ in read_includes(file)
                     if included.startswith("ixos/") and not file.startswith("ixos/")]
    if problems:
        sys.exit("\n".join(problems))
    print(f"{len(headers)} stable headers with {sum(len(read_names(h)) for h in headers)} names are as {GUIDE} says; "
          f"{len(list(PROGRAMS.glob('*.cpp')))} programs include no other")


if __name__ == "__main__":
    main()
