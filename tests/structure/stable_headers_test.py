#!/usr/bin/python3
"""Checks that the stable headers, lib/ixos, are what docs/embedding.md says.

    tests/structure/stable_headers_test.py

- A stable header only includes headers of lib. Its comment lists the names that are stable after "Stable:".
  headers_test.py compiles a use of each.
- The table of docs/embedding.md has a row for each stable header with the same names.
- Inline code of the three pages on embedding names only stable classes and functions, members of classes that the
  stable headers include, words of scenes (docs/parameters.md), and a few names of other libraries.
- No other file of lib includes a stable header.
- Example programs (docs/examples/programs) include stable headers only, and each is built by the CMakeLists.txt there.

The exit status is 1 if anything differs.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import INCLUDE, LIB, ROOT, is_header_of_lib, list_files, read_includes, read_stable_names  # noqa: E402

GUIDE = "docs/embedding.md"
PAGES = (GUIDE, "docs/embedding-evaluator.md", "docs/embedding-stepping.md")
# Names in these pages that are not of Ixos, and two that the guide calls internal.
FOREIGN = {"CMakeLists", "CMAKE_PREFIX_PATH", "find_package", "Tpetra", "Thyra", "InArgs", "OutArgs", "W_op", "W_prec",
           "W_x_dot_dot_coeff", "DgDx", "DgDx_dot", "DERIV_MV_GRADIENT_FORM", "g", "isFailed", "std",
           "GapLaw", "ElasticLaw"}
PROGRAMS = ROOT / "docs" / "examples" / "programs"
ROW = re.compile(r"\|\s*`<(ixos/\w+\.hpp)>`\s*\|[^|]*\|([^|]*)\|\s*$", re.MULTILINE)


def check_header(header):
    """Yields a message for each fault of one stable header."""
    place = f"lib/{header}"
    if header.count("/") != 1:
        yield f"{place}: stable headers stand in lib/ixos itself: move it there"
    included = [name for _, name, _ in read_includes(header)]
    for name in included:
        if not is_header_of_lib(name) or name.startswith("ixos/"):
            yield f"{place}: a stable header only includes other headers of lib: remove {name}"
    if not read_stable_names(header):
        yield f"{place}: its comment has no list \"Stable: ...\": add the stable names"


def check_guide(headers):
    """Yields a message for each stable header whose row in the guide is missing or differs."""
    rows = dict(ROW.findall((ROOT / GUIDE).read_text(encoding="utf-8")))
    for header in headers:
        if header not in rows:
            yield f"{GUIDE}: the table has no row for `<{header}>`: add one"
            continue
        told = set(re.findall(r"`(\w+)`", rows[header]))
        for name in sorted(told ^ set(read_stable_names(header))):
            yield f"{GUIDE}: {name} is stable in either the row of `<{header}>` or lib/{header}, not in both"
    for header in sorted(set(rows) - set(headers)):
        yield f"{GUIDE}: lib/{header} does not exist: delete its row"


def check_pages(headers):
    """Yields a message for each name in the pages on embedding that a program must not use."""
    stable = {name for header in headers for name in read_stable_names(header)}
    included = {name for header in headers for _, name, _ in read_includes(header) if is_header_of_lib(name)}
    text = "\n".join((LIB / name).read_text(encoding="utf-8") for name in included)
    members = set(re.findall(r"(\w+)\(", "\n".join(line for line in text.splitlines() if line.startswith(" "))))
    members -= set(re.findall(r"^\w.* [*&]?(\w+)\(", text, re.MULTILINE))  # functions of no class
    scene_words = set(re.findall(r"\w+", (ROOT / "docs/parameters.md").read_text(encoding="utf-8")))
    for page in PAGES:
        prose = re.sub(r"```.*?```", "", (ROOT / page).read_text(encoding="utf-8"), flags=re.DOTALL)
        for code in re.findall(r"`([^`\n]+)`", prose):
            if "/" in code:  # a file, or the path of a parameter
                continue
            types = set(re.findall(r"(?<![.\w:>])(?:ixos::)?([A-Z]\w*)", code)) - scene_words
            functions = set(re.findall(r"(?<![.\w:>])(?:ixos::)?([a-z_]\w*)\(", code)) - members
            for name in sorted((types | functions) - stable - FOREIGN):
                yield f"{page}: `{code}`: {name} is not stable: list it in a header of lib/ixos, or do not name it"


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
    problems += check_pages(headers)
    problems += check_programs()
    for file in list_files(".hpp", ".cpp"):
        problems += [f"lib/{file}:{line}: include the header that {included} includes, not this one"
                     for line, included, _ in read_includes(file)
                     if included.startswith("ixos/") and not file.startswith("ixos/")]
    if problems:
        sys.exit("\n".join(problems))
    names = sum(len(read_stable_names(header)) for header in headers)
    print(f"{len(headers)} stable headers with {names} names are as {GUIDE} says; "
          f"{len(list(PROGRAMS.glob('*.cpp')))} programs include no other")


if __name__ == "__main__":
    main()
