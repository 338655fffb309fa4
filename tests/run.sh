#!/usr/bin/env bash
# Installs what is missing, builds, runs the C++ tests (ctest) and the FMU tests (pytest).
# Exits with 1 if any of them failed.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_debian_packages
install_python_packages
build_drape -DDRAPE_TESTS=ON -DDRAPE_REFERENCE=ON -DDRAPE_BENCH=ON

failed=0
say "C++ tests"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" 2>&1 | tee "$build/ctest.log" || failed=1
say "FMU tests"
(cd "$root" && "$python" -m pytest tests/fmpy) 2>&1 | tee "$build/pytest.log" || failed=1

say "Summary"
grep -E 'tests passed' "$build/ctest.log" || echo "ctest did not finish"
tail -n 1 "$build/pytest.log"
exit $failed
