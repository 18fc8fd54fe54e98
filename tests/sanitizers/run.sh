#!/usr/bin/env bash
# Runs unit tests with a part of the code under AddressSanitizer and UBSan:
#   tests/sanitizers/run.sh PART [options of ctest]
# headers                    the templates of the headers, in the tests that instantiate them: tests/CMakeLists.txt
# bodies, steps or scenes    a third of the library's sources each: lib/CMakeLists.txt
# A whole build under sanitizers takes two hours (preset sanitize). A part is a quarter of that: what is under sanitizers
# stands beside the objects of the release build, and all else is that of the release build.
part=${1:?headers, bodies, steps or scenes}
shift
targets="unit_tests ixos_sanitized_$part"
case $part in
  headers) targets=sanitized_tests ;;
  bodies) tests='base|fem|guide|interaction|material|mesh|meshes|model|solve|term' ;;
  steps) tests='adapt|checkpoint|costs|driver|hdf5_fields|mesh_follower_ranks|restart|restart_obstacles|run|solve|time' ;;
  scenes) tests='base|corpus|driver|guide|io|scene|study|study_driver|units' ;;
  *) echo "tests/sanitizers/run.sh: $part is none of headers, bodies, steps, scenes" >&2 && exit 2 ;;
esac
[ "$part" != steps ] || targets+=" ixos_sanitized_steps_solvers"
. "$(dirname "${BASH_SOURCE[0]}")/../../drivers/common.sh"
export ASAN_OPTIONS=detect_leaks=0 # MPI keeps what it allocates
run=(ctest --test-dir "$build" --no-tests=error --output-on-failure -j "$(nproc)" -LE long)

if [ "$part" = headers ]; then
  exec "${run[@]}" -C sanitized -L sanitized "$@"
fi

library=$build/lib/sanitized/$part
loaded=$(LD_LIBRARY_PATH="$library" ldd "$build/tests/test_base")
if ! grep -q "$library/libixos" <<<"$loaded"; then
  echo "tests/sanitizers/run.sh: the tests do not load the library of $library" >&2
  exit 1
fi
# The tests that are left out start the program hundreds of times.
exec env LD_PRELOAD="$(g++ -print-file-name=libasan.so):$(g++ -print-file-name=libubsan.so)" LD_LIBRARY_PATH="$library" \
  GTEST_FILTER="-RestartDriverTest.*:HostileNamesTest.*:FailuresTest.*" "${run[@]}" -L unit -R "^(unit|guide)\.($tests)(\.|$)" "$@"
