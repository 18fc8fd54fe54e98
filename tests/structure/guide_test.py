#!/usr/bin/python3
"""Checks that the guides' code is tested as it stands.

    tests/structure/guide_test.py

Each block of C++ in docs/developer-guide.md must stand, apart from white space, in a source file of tests/guide, which
the suite compiles and tests, or of lib; each one in docs/embedding-stepping.md in a program of docs/examples/programs.
Each block of XML in docs/user-guide.md must stand in a scene of tests/guide.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import ROOT  # noqa: E402


def squeeze(text):
    """Returns the text without white space."""
    return re.sub(r"\s+", "", text)


def find_code(page):
    """Returns the blocks of C++ in a page."""
    return re.findall(r"```cpp\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)


def find_untested_scenes():
    """Returns the blocks of XML in the user guide that are in no scene of tests/guide."""
    scenes = [squeeze(path.read_text(encoding="utf-8")) for path in (ROOT / "tests/guide").glob("*.xml")]
    blocks = re.findall(r"```xml\n(.*?)```", (ROOT / "docs/user-guide.md").read_text(encoding="utf-8"), re.DOTALL)
    return [block for block in blocks if not any(squeeze(block) in scene for scene in scenes)]


def main():
    scenes = find_untested_scenes()
    for block in scenes:
        print("docs/user-guide.md: this scene is in no file of tests/guide:\n" + block)
    sources = [*(ROOT / "tests/guide").glob("*.cpp"), *(ROOT / "lib").rglob("*.[ch]pp")]
    code = [squeeze(path.read_text(encoding="utf-8")) for path in sources]
    blocks = find_code("docs/developer-guide.md")
    missing = [block for block in blocks if not any(squeeze(block) in text for text in code)]
    for block in missing:
        print("docs/developer-guide.md: this code is in no source of tests/guide or lib:\n" + block)
    programs = [squeeze(path.read_text(encoding="utf-8")) for path in (ROOT / "docs/examples/programs").glob("*.cpp")]
    for block in find_code("docs/embedding-stepping.md"):
        if not any(squeeze(block) in text for text in programs):
            print("docs/embedding-stepping.md: this code is in no program of docs/examples/programs:\n" + block)
            missing.append(block)
    if not blocks:
        sys.exit("docs/developer-guide.md has no C++ code: is the pattern out of date?")
    print(f"{len(blocks)} blocks of the guide; {len(missing)} of it or of other pages are not compiled")
    sys.exit(1 if missing or scenes else 0)


if __name__ == "__main__":
    main()
