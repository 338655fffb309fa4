#!/usr/bin/env bash
# From a bare Debian 12 to a simulated woollen cloth: installs what is missing, builds, packs an FMU of
# examples/hanging_wool, simulates it with FMPy, prints figures and draws a picture.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tests/setup.sh"

install_debian_packages
install_python_packages
build_drape

say "A woollen cloth as an FMU"
"$python" "$root/examples/hanging_wool/run.py"
