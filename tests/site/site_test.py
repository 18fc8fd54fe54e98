#!/usr/bin/python3
"""Makes the site of the documents and checks that it opens offline: links, pictures, style and search.

    tests/site/site_test.py [SITE]

Takes a site that was made already, or makes one. Every document and every example must have a page, and the start page
must name the version. Exit status 77, a skipped test, if Sphinx is missing.
"""
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOADED = {("script", "src"), ("img", "src"), ("link", "href")}  # what a browser fetches by itself
WORDS = ["peel", "checkpoint", "hamak", "mp4", "movi", "parallel", "troubleshoot", "symmetri"]  # stems that the search must find


class Page(html.parser.HTMLParser):
    """The anchors and references of a page."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.references = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        self.references += [(tag, name, values[name]) for name in ("href", "src") if values.get(name)]


def problems(site):
    """Returns a line for each dead link, and for each page that a browser could not show offline."""
    pages = {path.resolve(): Page(path) for path in site.rglob("*.html") if "_static" not in path.parts}
    found = []
    for path, page in pages.items():
        for tag, name, reference in page.references:
            target = urllib.parse.urlparse(reference)
            place = f"{path.relative_to(site)}: {reference}"
            if target.scheme or target.netloc:
                if (tag, name) in LOADED and target.scheme != "data":
                    found.append(f"{place}: loaded from the net")
                continue
            file = (path.parent / urllib.parse.unquote(target.path)).resolve() if target.path else path
            if not file.is_file():
                found.append(f"{place}: no such file")
            elif target.fragment and file in pages and target.fragment not in pages[file].anchors:
                found.append(f"{place}: no such anchor")
    return found


def style_problems(site):
    """Returns a line for each file that a style sheet names, if it is not there."""
    found = []
    for sheet in (site / "_static").rglob("*.css"):
        for reference in re.findall(r"url\([\"']?([^\"')]+)", sheet.read_text(encoding="utf-8")):
            if not reference.startswith(("data:", "#")) and not (sheet.parent / reference).is_file():
                found.append(f"{sheet.relative_to(site)}: {reference}: no such file")
    return found


def unfound(site):
    """Returns what is missing from the index of the search, which a page loads as a script: that works offline."""
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    documents = [path.relative_to(ROOT).with_suffix("").as_posix() for path in (ROOT / "docs").rglob("*.md")]
    examples = [path.relative_to(ROOT).as_posix() for path in (ROOT / "docs/examples").rglob("*")
                if path.suffix in (".cpp", ".py")]
    words = [word for word in WORDS if not re.search(rf'\b{word}"?:', index)]
    return words + [page for page in sorted(documents + examples) if f'"{page}"' not in index]


def version_problems(site):
    version = re.search(r"project\(Ixos VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    start = (site / "index.html").read_text(encoding="utf-8")
    return [] if f"Ixos {version}" in start else [f"index.html does not name the version {version}"]


def overwrites_other_files():
    """Returns whether docs/site.sh replaces a folder with files that are no site."""
    with tempfile.TemporaryDirectory() as folder:
        thesis = pathlib.Path(folder, "thesis.tex")
        thesis.touch()
        made = subprocess.run([ROOT / "docs/site.sh", folder], capture_output=True, check=False)
        return made.returncode == 0 or not thesis.exists()


def main():
    with tempfile.TemporaryDirectory() as folder:
        site = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else folder).resolve()
        if len(sys.argv) == 1:
            made = subprocess.run([ROOT / "docs/site.sh", site], capture_output=True, text=True, check=False)
            if "apt install" in made.stderr:
                print(made.stderr)
                return 77
            if made.returncode != 0:
                print(made.stdout + made.stderr)
                return 1
        wrong = problems(site) + style_problems(site) + version_problems(site)
        if overwrites_other_files():
            wrong.append("docs/site.sh replaces a folder with other files")
        wrong += [f"the search does not find {missing}" for missing in unfound(site)]
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
