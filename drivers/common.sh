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

missing=()
for package in $packages ${extra_packages:-} ${IXOS_EXTRA_PACKAGES:-}; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "Installing: ${missing[*]}"
  sudo=""
  [ "$(id -u)" -eq 0 ] || sudo=sudo
  $sudo apt-get update -qq
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

# Containers run as root; the two cores are shared.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OPENBLAS_NUM_THREADS=1

(
  cd "$root"
  [ -f "$build/build.ninja" ] || cmake --preset "$preset"
  cmake --build "$build" ${targets:+--target $targets}
)
