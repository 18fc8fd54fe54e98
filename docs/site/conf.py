# Settings of Sphinx for docs/site.sh.
import pathlib
import re

root = pathlib.Path(__file__).resolve().parents[2]
project = "Ixos"
release = re.search(r"project\(Ixos VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
extensions = ["myst_parser"]
myst_heading_anchors = 4  # the anchors of headings that GitHub makes
exclude_patterns = ["docs/man", "docs/site"]
smartquotes = False  # quotes around values are what a user types
html_theme = "furo"
html_title = f"Ixos {release}"
html_show_copyright = False
html_copy_source = False
html_use_index = False  # it would be empty
html_show_search_summary = False  # a page of a file system must not fetch another


def setup(app):
    from pygments.lexers.special import TextLexer
    app.add_lexer("geo", TextLexer)  # geometries of gmsh
