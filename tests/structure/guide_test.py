#!/usr/bin/python3
"""Checks that the developer guide's C++ code is compiled as it stands.

    tests/structure/guide_test.py

Each block of C++ in docs/developer-guide.md must stand, apart from white space, in a source file of tests/guide, which
the suite compiles and tests, or of lib.
"""
import re
import sys

sys.dont_write_bytecode = True
from includes import ROOT  # noqa: E402


def squeeze(text):
    """Returns the text without white space."""
    return re.sub(r"\s+", "", text)


def main():
    sources = [*(ROOT / "tests/guide").glob("*.cpp"), *(ROOT / "lib").rglob("*.[ch]pp")]
    code = [squeeze(path.read_text(encoding="utf-8")) for path in sources]
    guide = (ROOT / "docs/developer-guide.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```cpp\n(.*?)```", guide, re.DOTALL)
    missing = [block for block in blocks if not any(squeeze(block) in text for text in code)]
    for block in missing:
        print("docs/developer-guide.md: this code is in no source of tests/guide or lib:\n" + block)
    if not blocks:
        sys.exit("docs/developer-guide.md has no C++ code: is the pattern out of date?")
    print(f"{len(blocks) - len(missing)} of {len(blocks)} blocks of the guide are compiled")
    sys.exit(1 if missing else 0)


if __name__ == "__main__":
    main()
