#!/usr/bin/python3
"""Compares the includes of lib with the table "Layout of the code" in docs/developer-guide.md.

    tests/structure/folders_test.py

The third column of the table names the folders whose headers a folder includes. Each folder of lib has a row; a folder
inside it has one of its own, or belongs to the row of the folder around it. A header in backquotes, such as
`checkpoint/record.hpp`, may be included by every folder, without the rest of its folder. The test also checks which
folders include headers of certain libraries, and that no folder includes headers of a higher floor of the guide's
picture. The exit status is 1 if anything differs.
"""
import graphlib
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from includes import LIB, ROOT, is_header_of_lib, list_files, read_includes  # noqa: E402

GUIDE = "docs/developer-guide.md"
ROW = re.compile(r"\|\s*`lib/([^`]+)`\s*\|[^|]*\|([^|]*)\|\s*$")

# By folder, the libraries that no other folder includes, and what the names of their headers look like.
RESERVED = (("solve/loaded", "Stratimikos, MueLu, Thyra's Ifpack2 or MUMPS", r"(Thyra_)?(Stratimikos|MueLu|Ifpack2)|[ds]mumps_c"),
            ("solve", "NOX, Stratimikos, Ifpack2 or Amesos2", r"(\w+_)?(NOX|Stratimikos|Ifpack2|Amesos2)"),
            ("io", "HDF5", r"hdf5\w*\.h$|H5"),
            ("io", "Exodus", r"exodus"))
TRILINOS = re.compile(r"(Teuchos|Tpetra|Thyra|Kokkos)_")


ROOMS = set()  # the folders with a row


def folder_of(file):
    """Returns the innermost folder with a row that a file of lib is in, or its top-level folder; of a row its own."""
    if file in ROOMS:
        return file
    return next((str(folder) for folder in pathlib.PurePosixPath(file).parents if str(folder) in ROOMS),
                file.split("/")[0])


def is_kernel(file):
    """Returns whether a file must do without Trilinos. The entries of the materials' catalogue read parameter lists."""
    entry = file.startswith(("material/laws/", "material/catalogue."))
    return folder_of(file) in ("element", "fem", "material", "rule") and not entry


class Row:
    """One row of the table: the folders and the single headers that a folder of lib may include."""

    def __init__(self, line, cell):
        self.place = f"{GUIDE}:{line}"
        self.folders, self.headers = set(), set()
        for word in cell.split(","):
            word = word.strip().strip("`").removeprefix("lib/")
            if word.endswith(".hpp"):
                self.headers.add(word)
            elif word not in ("", "-", "–", "—"):
                self.folders.add(word)


def read_table():
    """Returns the rows of the table by folder."""
    rows, inside = {}, False
    with open(ROOT / GUIDE, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            if line.startswith("#"):
                inside = line.strip("# \n") == "Layout of the code"
            elif inside and (match := ROW.match(line)):
                rows[match[1].rstrip("/")] = Row(number, match[2])
    return rows


def check_rows(rows, folders):
    """Yields a message for each folder without a row, and for each name in the table that does not exist."""
    for folder in sorted(folders - set(rows)):
        yield f"{GUIDE}: the table has no row for lib/{folder}: add one"
    for folder, row in rows.items():
        if not (LIB / folder).is_dir():
            yield f"{row.place}: lib/{folder} does not exist: delete the row or correct the name"
        for name in sorted(row.folders - set(rows)):
            yield f"{row.place}: \"{name}\" has no row: delete or correct it"
        for name in sorted(header for header in row.headers if not is_header_of_lib(header)):
            yield f"{row.place}: lib/{name} does not exist: delete or correct it"


def check_includes(rows, includes):
    """Yields a message for each include of another folder that the table does not allow."""
    single = {header for row in rows.values() for header in row.headers}
    for file, line, included, quoted in includes:
        place, own = f"lib/{file}:{line}", folder_of(file)
        if quoted and not is_header_of_lib(included):
            yield f"{place}: \"{included}\" is no header of lib: write its path below lib, or <> for another library"
        elif is_header_of_lib(included) and own in rows:
            other = folder_of(included)
            if other != own and other not in rows[own].folders and included not in single:
                yield (f"{place}: lib/{own} may not include {included}: remove the include, or add {other} to "
                       f"{rows[own].place}")


def check_use(rows, includes):
    """Yields a message for each folder or header in the table that no include needs."""
    used = {(folder_of(file), name) for file, _, included, _ in includes for name in (folder_of(included), included)}
    for folder, row in rows.items():
        for name in sorted(row.folders | row.headers):
            if not (LIB / name).exists():
                continue  # check_rows() tells
            if folder_of(name) == folder:
                yield f"{row.place}: a folder may always include its own headers: delete {name}"
            elif folder_of(name) in row.folders and name in row.headers:
                yield f"{row.place}: the row allows all of {folder_of(name)}: delete {name}"
            elif (folder, name) not in used:
                yield f"{row.place}: no file of lib/{folder} includes {name} any more: delete it from the row"


def check_cycles(rows, includes):
    """Yields a message if the folders include each other in a cycle.

    A single header counts as a folder of its own, which includes what this header includes.
    """
    single = {header for row in rows.values() for header in row.headers}
    graph = {folder: row.folders | row.headers for folder, row in rows.items()}
    for file, _, included, _ in includes:
        own, other = folder_of(file), folder_of(included)
        if file in single:
            graph.setdefault(file, set()).add(included if included in single else other)
        elif included in single and other != own and other not in graph.setdefault(own, set()):
            graph[own].add(included)
    for name, below in graph.items():
        below.discard(name)
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        # The standard library names each member of the cycle after one that it includes.
        path = " -> ".join(reversed(error.args[1]))
        yield f"{GUIDE}: folders include each other: {path}: move what one of them needs into a folder below it"


def check_floors(rows):
    """Yields a message for each folder that is on no floor of the guide's picture, and for each include of a higher one.

    A line of the picture is a floor: names of folders, two spaces, words. The highest comes first.
    """
    picture = re.search(r"```text\n(.*?)```", (ROOT / GUIDE).read_text(encoding="utf-8"), re.DOTALL)
    floors = {}
    for height, line in enumerate(reversed(picture[1].splitlines()), 1):
        for name in re.split(r" {2,}", line)[0].split(", "):
            floors[name] = height
    floor_of = {folder: floors.get(folder.split("/")[0], 0) for folder in rows if folder != "ixos"}
    for folder, floor in floor_of.items():
        if not floor:
            yield f"{GUIDE}: the picture of the floors has no lib/{folder}: add it"
        for other in sorted(rows[folder].folders):
            if floor_of.get(other, 0) > floor > 0:
                yield f"{GUIDE}: lib/{folder} includes headers of {other}, which is on a higher floor of the picture"


def check_libraries(files):
    """Yields a message for each include of a library's header outside the folder that this library belongs to."""
    for file, line, included, _ in files:
        for folder, library, pattern in () if is_header_of_lib(included) else RESERVED:
            if not file.startswith(folder + "/") and re.match(pattern, included.split("/")[-1]):
                yield f"lib/{file}:{line}: only lib/{folder} may include {library}: move the code there"


def find_trilinos(header, seen):
    """Returns the path of includes from a header to one of Trilinos, or an empty list."""
    if TRILINOS.match(header):
        return [header]
    if header in seen or not is_header_of_lib(header):
        return []
    seen.add(header)
    for _, included, _ in read_includes(header):
        if rest := find_trilinos(included, seen):
            return [header, *rest]
    return []


def check_kernels(files):
    """Yields a message for each include of a kernel that leads to a header of Trilinos."""
    for file, line, included, _ in files:
        # A kernel's own includes have messages of their own.
        if is_kernel(file) and not (is_header_of_lib(included) and is_kernel(included)):
            if path := find_trilinos(included, set()):
                yield (f"lib/{file}:{line}: a kernel must not include Trilinos, but this does: {' -> '.join(path)}: "
                       "move the code that needs it out of the kernel")


def main():
    rows = read_table()
    ROOMS.update(rows)
    if not rows:
        sys.exit(f"{GUIDE}: no row of the table \"Layout of the code\" begins with | `lib/NAME` |: restore the table")
    folders = {folder_of(file) for file in list_files(".hpp", ".cpp", ".def")}
    files = [(file, *include) for file in list_files(".hpp", ".cpp") for include in read_includes(file)]
    own = [include for include in files if include[3] or is_header_of_lib(include[2])]
    problems = [*check_rows(rows, folders), *check_includes(rows, own), *check_use(rows, own),
                *check_cycles(rows, [include for include in own if is_header_of_lib(include[2])]),
                *check_floors(rows), *check_libraries(files), *check_kernels(files)]
    if problems:
        sys.exit("\n".join(problems))
    arrows = {(folder_of(file), folder_of(included)) for file, _, included, _ in own}
    print(f"{len(own)} includes of {len(folders)} folders are as {GUIDE} says: "
          f"{sum(a != b for a, b in arrows)} arrows, no cycle")


if __name__ == "__main__":
    main()
