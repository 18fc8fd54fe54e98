#!/usr/bin/env bash
# Installs what is missing, builds Ixos, and runs a scene: drivers/run.sh [SCENE.xml] [options of ixos]
# Without arguments: xml/ball.xml, results in ball.results.
targets="ixos_driver ixos_study"
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
[ $# -gt 0 ] || set -- "$root/xml/ball.xml" --output "$root/ball.results"
exec "$build/drivers/ixos" "$@"
