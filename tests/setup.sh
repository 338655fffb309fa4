# Sourced by examples/quickstart.sh, tests/run.sh and .ci/run. Installs what is missing, configures and builds into build/.
# Everything that is already there is left alone, so a second run needs no network and takes seconds.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build="$root/build"
python="$root/.venv/bin/python"

# The Debian packages of the quickstart. The last line is what VTK loads to draw without a screen.
debian_packages=(
  g++ cmake ninja-build pkg-config python3 python3-venv
  libeigen3-dev libtomlplusplus-dev libzip-dev zlib1g-dev libfcl-dev libtinyobjloader-dev nlohmann-json3-dev
  libcli11-dev libpugixml-dev
  libegl1 libgl1-mesa-dri
)

# What the reference, the benchmark and the tests add. libsundials-dev alone brings MPI, PETSc
# and some 170 packages more, so the quickstart does without it.
test_packages=(libsundials-dev libgtest-dev)

say() { printf '\n== %s\n' "$*"; }
die() { printf 'drape: %s\n' "$*" >&2; exit 1; }

# install_debian_packages [package ...]: those of the quickstart, and these.
install_debian_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "Not a Debian system: going on with the compiler and libraries that are installed"
    return
  fi
  local missing=() package
  for package in "${debian_packages[@]}" "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return
  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [[ -t 0 ]]; } ||
      die "these Debian packages are missing and need an administrator to install them: ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing Debian packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -q </dev/null
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
}

install_python_packages() {
  local wanted="$root/tests/requirements.txt" installed="$root/.venv/installed.txt" candidate
  cmp -s "$wanted" "$installed" && "$python" -c 'import fmpy' 2>/dev/null && return
  if ! "$python" -m pip --version >/dev/null 2>&1; then
    for candidate in python3 python3.14 python3.13 python3.12 python3.11 none; do
      "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && break
    done
    [[ $candidate != none ]] || die "Python 3.11 or newer is needed; python3 is $(python3 --version 2>&1)"
    say "Making a Python environment in .venv"
    rm -rf "$root/.venv"
    "$candidate" -m venv "$root/.venv"
  fi
  say "Installing Python packages into .venv"
  "$python" -m pip install --quiet --disable-pip-version-check -r "$wanted" </dev/null
  cp "$wanted" "$installed"
}

# stage NAME command ...: runs it and prints how long it took. The lines are kept in `stages`, and in the file
# $DRAPE_STAGES if a script above this one has named it.
stages=()
stage() {
  local name=$1 start=$SECONDS
  shift
  say "$name"
  "$@"
  stages+=("$(printf '%6d s  %s' $((SECONDS - start)) "$name")")
  echo "${stages[-1]}"
  [[ -z ${DRAPE_STAGES:-} ]] || echo "${stages[-1]}" >>"$DRAPE_STAGES"
}

# is_moved FOLDER: this build folder was moved or copied together with its tree.
is_moved() {
  [[ -f $1/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt"
}

# build_drape [cmake options]: options given once stay in build/, so the two scripts can share the folder.
build_drape() {
  local fresh=()
  if is_moved "$build"; then fresh=(--fresh); fi
  say "Building into build/"
  (cd "$root" && cmake --preset release "${fresh[@]}" --log-level=WARNING "$@" && cmake --build "$build")
}
