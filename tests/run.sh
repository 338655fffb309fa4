#!/usr/bin/env bash
# Installs what is missing, builds, runs the C++ tests (ctest) and the FMU tests (pytest).
# Exits with 1 if any of them failed.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

failed=0
run_ctest() { ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" 2>&1 | tee "$build/ctest.log" || failed=1; }
run_pytest() { (cd "$root" && "$python" -m pytest -n "$(nproc)" --dist loadfile --no-loadscope-reorder tests/fmpy) 2>&1 | tee "$build/pytest.log" || failed=1; }

stage "Debian packages" install_debian_packages "${test_packages[@]}"
stage "Python packages" install_python_packages
stage "Build" build_drape -DDRAPE_TESTS=ON -DDRAPE_REFERENCE=ON -DDRAPE_BENCH=ON
stage "C++ tests" run_ctest
stage "FMU tests" run_pytest

say "Summary"
printf '%s\n' "${stages[@]}"
grep -E 'tests passed' "$build/ctest.log" || echo "ctest did not finish"
tail -n 1 "$build/pytest.log"
exit $failed
