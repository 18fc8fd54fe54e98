#!/usr/bin/env bash
# Installs what is missing, builds Ixos, checks the style and runs all tests: tests/run.sh [options of ctest]
extra_packages="clang-format clang-tidy"
. "$(dirname "${BASH_SOURCE[0]}")/../drivers/common.sh"
"$root/tests/check_style.sh" "$build"
exec ctest --test-dir "$build" --output-on-failure "$@"
