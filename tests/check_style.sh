#!/usr/bin/env bash
# Formatting of every source file, and clang-tidy on those that changed since the last clean run in this build folder
# (all of them in a fresh one): tests/check_style.sh BUILD_FOLDER
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1
mapfile -t sources < <(find lib drivers tests -name '*.cpp' -o -name '*.hpp' | sort)
[ ${#sources[@]} -gt 0 ] || { echo "check_style.sh: no sources found" >&2; exit 1; }
clang-format --dry-run --Werror "${sources[@]}"

stamps="$build/tidy"
mkdir -p "$stamps"
todo=()
for source in "${sources[@]}"; do
  case "$source" in
    lib/*.cpp | drivers/*.cpp) ;;
    *) continue ;;
  esac
  stamp="$stamps/${source//\//_}"
  # Headers count too: any change to one of ours makes every file stale.
  key=$(cat "$source" .clang-tidy $(find lib drivers -name '*.hpp' | sort) | sha256sum)
  [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$key" ] || { todo+=("$source"); printf '%s' "$key" >"$stamp.new"; }
done
[ ${#todo[@]} -eq 0 ] && exit 0
echo "clang-tidy on ${#todo[@]} files"
printf '%s\n' "${todo[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p "$build" --quiet 2>/dev/null
for source in "${todo[@]}"; do mv "$stamps/${source//\//_}.new" "$stamps/${source//\//_}"; done
