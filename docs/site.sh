#!/usr/bin/env bash
# Makes the documents as a site that opens offline, with search: docs/site.sh [FOLDER] (default: build/site)
# Open FOLDER/index.html. The site has README.md, CONTRIBUTING.md, CHANGELOG.md, every page below docs and the examples.
# A new page below docs needs no entry anywhere. A dead link is an error. Replaces an earlier site in FOLDER. Needs
# Debian's packages python3-sphinx, python3-myst-parser and furo.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
site=$(realpath -m "${1:-$root/build/site}")
if ! /usr/bin/python3 -c "import sphinx, myst_parser, furo" 2>/dev/null; then
  echo "docs/site.sh: needs: apt install python3-sphinx python3-myst-parser furo" >&2
  exit 1
fi
if [ -e "$site" ] && [ ! -e "$site/searchindex.js" ] && [ -n "$(ls -A "$site")" ]; then
  echo "docs/site.sh: $site has files that are no site; choose another folder" >&2
  exit 1
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
pages=$work/pages html=$work/html
mkdir "$pages"
cd "$root"
cp --parents -r docs meshes/README.md README.md CONTRIBUTING.md CHANGELOG.md CITATION.cff LICENSE "$pages"
/usr/bin/python3 docs/site/pages.py "$pages"
/usr/bin/python3 -m sphinx -q -W --keep-going -b html -d "$work/doctrees" -c docs/site "$pages" "$html"
# Debian's furo imports a style sheet of another package by an address of a server.
normalize=/javascript/normalize.css/normalize.css
if grep -qF "url($normalize)" "$html/_static/styles/furo.css"; then
  cp -L "/usr/share$normalize" "$html/_static/styles/"
  sed -i "s|url($normalize)|url(normalize.css)|" "$html/_static/styles/furo.css"
fi
rm -rf "$site"
mkdir -p "$(dirname "$site")"
mv "$html" "$site"
