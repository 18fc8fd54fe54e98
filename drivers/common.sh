# The steps that drivers/run.sh and tests/run.sh share: packages, configuration, build. Sourced, not run.
# Installs the missing packages of $packages, $extra_packages and $IXOS_EXTRA_PACKAGES with apt. Configures the preset
# IXOS_PRESET (default release). Builds $targets (default everything).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${IXOS_PRESET:-release}
build="$root/build/$preset"

packages="g++ cmake ninja-build ccache lld openmpi-bin libopenmpi-dev trilinos-all-dev libscotch-dev libptscotch-dev
          libopenblas-dev libsuitesparse-dev libmumps-dev libmetis-dev libmuparser-dev libexodusii-dev libhdf5-openmpi-dev libxxhash-dev libexpat1-dev libboost-dev libcli11-dev libfmt-dev nlohmann-json3-dev libgtest-dev
          libbenchmark-dev pybind11-dev python3-dev python3-numpy python3-mpi4py"

. "$root/drivers/install.sh"
install_missing $packages ${extra_packages:-} ${IXOS_EXTRA_PACKAGES:-}

# Containers run as root; the two cores are shared.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OPENBLAS_NUM_THREADS=1

# ccache serves a checkout with what it compiled in another one. The compiler then sees sources by their paths below the
# build folder, ../../lib/..., and the build folder that objects name for a debugger may be the other checkout's.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_ABSSTDERR=1

(
  cd "$root"
  [ -f "$build/build.ninja" ] || cmake --preset "$preset"
  cmake --build "$build" ${targets:+--target $targets}
)
