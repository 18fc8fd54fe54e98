#!/usr/bin/env bash
# Installs what is missing, builds Ixos, and runs a scene: drivers/run.sh [SCENE.xml] [options of ixos]
# Without arguments: xml/ball.xml, results in ball.results.
targets="ixos_driver ixos_study"
# A Python module that was built before stays one of this library.
compgen -G "$(dirname "${BASH_SOURCE[0]}")/../build/${IXOS_PRESET:-release}/python/ixos/_core*.so" >/dev/null &&
  targets+=" ixos_python"
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
[ $# -gt 0 ] || set -- "$root/xml/ball.xml" --output "$root/ball.results"
exec "$build/drivers/ixos" "$@"
