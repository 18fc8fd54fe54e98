"""Makes the pages of the site that are no documents: the start page with the contents, and a page for each example.

    docs/site/pages.py FOLDER

FOLDER holds copies of the documents. docs/site.sh calls this script.
"""
import os
import pathlib
import re
import sys

# The contents: captions, and below each its pages, or folders of pages. The first caption that names a page has it.
CONTENTS = {
    "Guide": ["docs/user-guide", "docs/python", "docs/embedding", "docs/embedding-evaluator", "docs/embedding-stepping",
              "docs/meshes", "docs/packages"],
    "Help by need": ["docs/help/", "docs/tutorials/scan-20/", "docs/tutorials/fit-data/"],
    "Tutorials": ["docs/tutorials/"],
    "Cookbook": ["docs/cookbook/"],
    "Examples": ["docs/examples/"],
    "Reference": ["docs/parameters", "docs/study-parameters", "docs/theory"],
    "Measurements": ["docs/results", "docs/results/", "docs/extremes", "docs/robustness"],
    "Project": ["docs/developer-guide", "CONTRIBUTING", "CHANGELOG", "docs/", "meshes/"],
}
LANGUAGES = {".cpp": "c++", ".py": "python"}


def program_page(path):
    """Returns the page of a program: its name and the file."""
    return f"# {path.name}\n\n```{{literalinclude}} {path.name}\n:language: {LANGUAGES[path.suffix]}\n```\n"


def notebook_page(text):
    """Returns the page of a notebook in the percent format: prose as prose, code as code."""
    page = ""
    for mark, cell in re.findall(r"(?ms)^# %%(.*?)\n(.*?)(?=^# %%|\Z)", text):
        if "[markdown]" in mark:
            page += re.sub(r"(?m)^# ?", "", cell).strip() + "\n\n"
        elif cell.strip():
            page += f"```python\n{cell.strip()}\n```\n\n"
    return page


def write_examples(folder):
    """Writes a page beside each example. Returns the examples."""
    examples = [path for path in sorted((folder / "docs/examples").rglob("*")) if path.suffix in LANGUAGES]
    for path in examples:
        text = path.read_text(encoding="utf-8")
        page = notebook_page(text) if "\n# %%" in text else program_page(path)
        path.with_name(path.name + ".md").write_text(page, encoding="utf-8")
    return examples


def link_examples(folder, examples):
    """Lets the links to examples lead to their pages."""
    for page in folder.rglob("*.md"):
        text = page.read_text(encoding="utf-8")
        for example in examples:
            target = os.path.relpath(example, page.parent)
            text = text.replace(f"]({target})", f"]({target}.md)")
        page.write_text(text, encoding="utf-8")


def contents(folder):
    """Returns the contents, which the theme shows beside each page."""
    left = [str(path.relative_to(folder).with_suffix("")) for path in sorted(folder.rglob("*.md"))]
    left.remove("README")
    text = ""
    for caption, entries in CONTENTS.items():
        pages = []
        for entry in entries:
            found = [name for name in left if name == entry or (entry.endswith("/") and name.startswith(entry))]
            if not found and not entry.endswith("/"):
                sys.exit(f"docs/site/pages.py: there is no page {entry}.md")
            pages += found
            left = [name for name in left if name not in found]
        if pages:
            text += "\n```{toctree}\n:hidden:\n:caption: " + caption + "\n\n" + "\n".join(pages) + "\n```\n"
    if left:
        sys.exit(f"docs/site/pages.py: the contents have no place for {', '.join(left)}")
    return text


def main():
    folder = pathlib.Path(sys.argv[1])
    link_examples(folder, write_examples(folder))
    start = (folder / "README.md").read_text(encoding="utf-8") + contents(folder)
    (folder / "README.md").unlink()
    (folder / "index.md").write_text(start, encoding="utf-8")


main()
