#!/usr/bin/env bash
# Installs what is missing, builds Ixos and its tests, and runs the quick ones: tests/run.sh [options of ctest]
# IXOS_LONG=1 runs the long ones too; IXOS_PRESET chooses another build (see CMakePresets.json).
extra_packages="python3-matplotlib python3-netcdf4 python3-numpy python3-pil python3-scipy python3-vtk9 gmsh xvfb xauth help2man python3-sphinx python3-myst-parser furo"
. "$(dirname "${BASH_SOURCE[0]}")/../drivers/common.sh"
[ "$preset" != sanitize ] || export ASAN_OPTIONS=detect_leaks=0 # MPI keeps what it allocates
[ "${IXOS_LONG:-0}" = 1 ] || set -- -LE long "$@"
exec ctest --test-dir "$build" --no-tests=error --output-on-failure -j "$(nproc)" "$@"
