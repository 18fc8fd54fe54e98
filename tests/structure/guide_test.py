#!/usr/bin/python3
"""Checks that the guides' code is tested as it stands.

    tests/structure/guide_test.py

Each block of C++ in docs/developer-guide.md must stand, apart from white space, in a source file of tests/guide, which
the suite compiles and tests, or of lib. Each block of C++ in docs/embedding.md, docs/embedding-evaluator.md and
docs/embedding-stepping.md must stand in a program of docs/examples/programs. Each block of XML in docs/user-guide.md
must stand in a scene of tests/guide or xml. docs/user-guide.md and docs/cookbook/README.md must link to each page of
docs/cookbook.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import ROOT  # noqa: E402


def squeeze(text):
    """Returns the text without white space."""
    return re.sub(r"\s+", "", text)


def find_untested_scenes():
    """Returns the blocks of XML in the user guide that are in no scene of tests/guide or xml."""
    scenes = [squeeze(path.read_text(encoding="utf-8")) for folder in ("tests/guide", "xml")
              for path in (ROOT / folder).glob("*.xml")]
    blocks = re.findall(r"```xml\n(.*?)```", (ROOT / "docs/user-guide.md").read_text(encoding="utf-8"), re.DOTALL)
    return [block for block in blocks if not any(squeeze(block) in scene for scene in scenes)]


def find_missing_code(page, sources):
    """Returns the number of blocks of C++ of a page, and those that stand in none of the source files."""
    code = [squeeze(path.read_text(encoding="utf-8")) for path in sources]
    blocks = re.findall(r"```cpp\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)
    if not blocks:
        sys.exit(f"{page} has no C++ code: is the pattern out of date?")
    return len(blocks), [block for block in blocks if not any(squeeze(block) in text for text in code)]


def find_unlinked_pages():
    """Yields a message for each page of the cookbook to which the guide or the cookbook's contents do not link."""
    pages = sorted((ROOT / "docs/cookbook").glob("*/*.md"))
    if not pages:
        sys.exit("docs/cookbook has no pages: is the pattern out of date?")
    for source in ("docs/user-guide.md", "docs/cookbook/README.md"):
        text = (ROOT / source).read_text(encoding="utf-8")
        for page in pages:
            if f"]({page.relative_to((ROOT / source).parent)})" not in text:
                yield f"{source}: it has no link to {page.relative_to(ROOT)}"


def main():
    scenes = find_untested_scenes()
    for block in scenes:
        print("docs/user-guide.md: this scene is in no file of tests/guide or xml:\n" + block)
    unlinked = list(find_unlinked_pages())
    for problem in unlinked:
        print(problem)
    wrong = len(scenes) + len(unlinked)
    programs = list((ROOT / "docs/examples/programs").glob("*.cpp"))
    for page, where, sources in (
            ("docs/developer-guide.md", "tests/guide or lib",
             [*(ROOT / "tests/guide").glob("*.cpp"), *(ROOT / "lib").rglob("*.[ch]pp")]),
            ("docs/embedding.md", "docs/examples/programs", programs),
            ("docs/embedding-evaluator.md", "docs/examples/programs", programs),
            ("docs/embedding-stepping.md", "docs/examples/programs", programs)):
        blocks, missing = find_missing_code(page, sources)
        for block in missing:
            print(f"{page}: this code is in no source of {where}:\n" + block)
        print(f"{blocks - len(missing)} of {blocks} blocks of {page} are compiled")
        wrong += len(missing)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
