#!/usr/bin/env bash
# Checks the format of every source file: tests/check_style.sh. clang-tidy is tests/check_tidy.py.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t sources < <(find lib drivers python tests docs/examples -name '*.cpp' -o -name '*.hpp' | sort)
[ ${#sources[@]} -gt 0 ] || { echo "check_style.sh: no sources found" >&2; exit 1; }
clang-format --dry-run --Werror "${sources[@]}"
