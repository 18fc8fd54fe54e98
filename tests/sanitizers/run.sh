#!/usr/bin/env bash
# Runs the unit tests with a part of the code under AddressSanitizer and UBSan: tests/sanitizers/run.sh PART [options of ctest]
#   headers                    the templates of the headers, in the tests that instantiate them
#   bodies, steps, scenes      a third of the library's sources each: lib/CMakeLists.txt
# A whole build under sanitizers takes two hours (preset sanitize). A part is a quarter of that: what is instrumented
# stands beside the objects of the release build, and the tests are those of the release build.
part=${1:?headers, bodies, steps or scenes}
shift
case $part in
  headers) targets=sanitized_tests ;;
  steps) targets="ixos_sanitized_steps ixos_sanitized_steps_solvers unit_tests" ;;
  bodies | scenes) targets="ixos_sanitized_$part unit_tests" ;;
  *) echo "tests/sanitizers/run.sh: $part is none of headers, bodies, steps, scenes" >&2 && exit 2 ;;
esac
. "$(dirname "${BASH_SOURCE[0]}")/../../drivers/common.sh"
export ASAN_OPTIONS=detect_leaks=0 # MPI keeps what it allocates

if [ "$part" = headers ]; then
  set -a
  . "$root/tests/support/openmpi.env"
  set +a
  for test in base fem interaction material term; do
    mpiexec -n 1 "$build/tests/sanitized_$test" --gtest_brief=1 --gtest_filter='-*LongTest.*'
  done
  mpiexec -n 2 "$build/tests/sanitized_term" --gtest_brief=1 --gtest_filter='-*LongTest.*:*SerialTest.*'
  exit
fi

runtime=$(g++ -print-file-name=libasan.so):$(g++ -print-file-name=libubsan.so)
library=$build/lib/sanitized/$part
loaded=$(LD_LIBRARY_PATH="$library" ldd "$build/tests/test_base")
if ! grep -q "$library/libixos" <<<"$loaded"; then
  echo "tests/sanitizers/run.sh: the tests do not load $library" >&2
  exit 1
fi
# The tests left out start the program hundreds of times.
exec env LD_PRELOAD="$runtime" LD_LIBRARY_PATH="$library" GTEST_FILTER="-RestartDriverTest.*:HostileNamesTest.*:FailuresTest.*" \
  ctest --test-dir "$build" --no-tests=error --output-on-failure -j "$(nproc)" -L unit -LE long "$@"
