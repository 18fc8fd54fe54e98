#!/usr/bin/env bash
# Makes the documents as a site that opens offline, with search: docs/site.sh [FOLDER] (default: build/site)
# Open FOLDER/index.html. The site has README.md, CONTRIBUTING.md, CHANGELOG.md and every page below docs. A dead link is
# an error. Needs Debian's packages python3-sphinx, python3-myst-parser and furo.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
site=$(realpath -m "${1:-$root/build/site}")
if ! /usr/bin/python3 -c "import sphinx, myst_parser, furo" 2>/dev/null; then
  echo "docs/site.sh: needs: apt install python3-sphinx python3-myst-parser furo" >&2
  exit 1
fi
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
pages=$work/pages
mkdir "$pages"
cd "$root"
cat README.md docs/site/contents.md > "$pages/index.md"
cp --parents -r docs meshes/README.md CONTRIBUTING.md CHANGELOG.md CITATION.cff LICENSE "$pages"
/usr/bin/python3 -m sphinx -q -W --keep-going -b html -d "$work/doctrees" -c docs/site "$pages" "$site"
