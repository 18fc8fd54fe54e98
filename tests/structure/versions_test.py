#!/usr/bin/python3
"""Checks that all places state the version of CMakeLists.txt, and one date for each release.

    tests/structure/versions_test.py

A release has an entry in CHANGELOG.md and in debian/changelog, and its golden files in tests/golden/VERSION. Between
releases CHANGELOG.md has a list "Unreleased" above the entries. The exit status is 1 if anything differs.
"""
import email.utils
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def packaged_releases():
    """Returns the versions and dates of debian/changelog, the newest first."""
    versions = re.findall(r"^ixos \(([^)]+)\)", read("debian/changelog"), re.MULTILINE)
    dates = re.findall(r"^ -- .*>  (.*)", read("debian/changelog"), re.MULTILINE)
    return [(version, email.utils.parsedate_to_datetime(date).date().isoformat())
            for version, date in zip(versions, dates, strict=True)]


def listed_releases():
    """Returns the same of CHANGELOG.md. The text of a heading that is no release stands in place of a version."""
    headings = re.findall(r"^## (.*)", read("CHANGELOG.md"), re.MULTILINE)
    if headings[:1] == ["Unreleased"]:
        headings.pop(0)
    matches = [(heading, re.fullmatch(r"(\d+\.\d+\.\d+) \((\d{4}-\d\d-\d\d)\)", heading)) for heading in headings]
    return [match.groups() if match else (heading, "no date") for heading, match in matches]


def problems():
    version = re.search(r"project\(Ixos VERSION ([\d.]+)", read("CMakeLists.txt"))[1]
    packaged, listed = packaged_releases(), listed_releases()
    if listed != packaged:
        yield f"CHANGELOG.md has the releases {listed}, debian/changelog {packaged}"
    if packaged[0][0] != version:
        yield f"debian/changelog: the version is {packaged[0][0]}, but the project's is {version}"
    cited = tuple(re.search(rf"^{key}: (.*)", read("CITATION.cff"), re.MULTILINE)[1]
                  for key in ("version", "date-released"))
    if cited != packaged[0]:
        yield f"CITATION.cff: it cites {cited}, but the last release is {packaged[0]}"
    minor = ".".join(version.split(".")[:2])
    if f"`find_package(Ixos {minor})`" not in read("docs/embedding.md"):
        yield f"docs/embedding.md does not ask for the version {minor}"
    for path in ("debian/control", "debian/rules"):
        if re.search(r"libixos\d", read(path)):
            yield f"{path} types the version; debian/rules takes it from debian/changelog"
    golden = ROOT / "tests/golden" / version
    if not (golden / "columns.txt").is_file():
        yield f"tests/golden/{version} has no columns.txt: see the developer guide, \"A release\""
    for scene in golden.glob("*.xml"):
        if "\"Checkpoint\"" in scene.read_text(encoding="utf-8") and not scene.with_suffix(".h5").is_file():
            yield f"{scene.relative_to(ROOT)} has no checkpoint beside it: see the developer guide, \"A release\""


found = list(problems())
if found:
    sys.exit("\n".join(f"versions_test.py: {problem}" for problem in found))
