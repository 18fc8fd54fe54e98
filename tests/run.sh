#!/usr/bin/env bash
# Installs what is missing, builds Ixos, checks the style and runs all tests: tests/run.sh [options of ctest]
extra_packages="clang-format clang-tidy python3-matplotlib python3-numpy python3-pil python3-vtk9 xvfb xauth"
. "$(dirname "${BASH_SOURCE[0]}")/../drivers/common.sh"
if [ "$preset" = sanitize ]; then
  export ASAN_OPTIONS=detect_leaks=0 # MPI keeps what it allocates
else
  "$root/tests/check_style.sh" "$build"
fi
exec ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
