#!/usr/bin/env bash
# The release build of the binaries that `drape pack` packs: for hosts with glibc 2.28 or newer, and for Windows.
#
#     fmu/release.sh [linux64|win64 ...]    default: both
#
# It needs a build of this tree (`bash examples/quickstart.sh`). The compiler is clang from the PyPI package `ziglang`, in
# a Python environment of its own. Everything lies in build/release: the compiler with its cache, one build folder a
# platform, and linux64/ and win64/, which `drape pack` takes by itself. Remove the folder, and nothing is left.
#
# The first build of a platform compiles the C++ runtime too. Two cores take 5 to 10 minutes for it. In all it takes
# 1.3 GB of disk.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tests/setup.sh"

zig_version=0.17.1
release="$build/release"
zig="" # the folder of the package

install_compiler() {
  local environment="$release/compiler"
  if [[ $(cat "$environment/version.txt" 2>/dev/null) != "$zig_version" ]]; then
    say "Installing ziglang $zig_version"
    rm -rf "$environment" "$release"/tree-*
    python3 -m venv "$environment"
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check "ziglang==$zig_version" </dev/null
    echo "$zig_version" >"$environment/version.txt"
  fi
  zig=$("$environment/bin/python" -c 'import os, ziglang; print(os.path.dirname(ziglang.__file__))')
  mkdir -p "$release/tools"
  local tool
  for tool in cc c++ ar ranlib rc; do
    printf '#!/bin/sh\nexec "%s/zig" %s "$@"\n' "$zig" "$tool" >"$release/tools/$tool"
    chmod +x "$release/tools/$tool"
  done
}

# The headers of the libraries alone: beside them in /usr/include lie those of this machine's C library.
link_headers() {
  local name folder
  mkdir -p "$release/include"
  for name in fcl toml++ tiny_obj_loader.h; do
    rm -f "$release/include/$name"
    for folder in /usr/include /usr/local/include; do
      if [[ -e $folder/$name ]]; then ln -sfn "$folder/$name" "$release/include/$name"; fi
    done
    [[ -e $release/include/$name ]] || die "the header $name is missing: run bash examples/quickstart.sh"
  done
}

build_platform() { # linux64|win64
  local tree="$release/tree-$1" fresh=()
  export ZIG_GLOBAL_CACHE_DIR="${ZIG_GLOBAL_CACHE_DIR:-$release/cache}" ZIG_LOCAL_CACHE_DIR="$release/cache-local"
  if is_moved "$tree"; then fresh=(--fresh); fi
  rm -rf "$tree/licenses" # of texts that are packed no more
  cmake -S "$root" -B "$tree" "${fresh[@]}" -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DDRAPE_FMU_ONLY=ON \
    -DCMAKE_TOOLCHAIN_FILE="$root/fmu/release.cmake" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_PREFIX_PATH=/usr \
    -DDRAPE_PLATFORM="$1" -DDRAPE_TOOLS="$release/tools" -DDRAPE_ZIG="$zig" -DDRAPE_ZIG_VERSION="$zig_version" \
    -DDRAPE_TOMLPLUSPLUS_HEADERS="$release/include" -DDRAPE_FCL_HEADERS="$release/include" \
    -DDRAPE_TINYOBJLOADER_HEADERS="$release/include"
  cmake --build "$tree" --target drape_fmi2 drape_contact
  rm -rf "${release:?}/$1"
  mkdir -p "$release/$1"
  local file
  for file in drape_fmi2.so libdrape_contact.so drape_fmi2.dll drape_contact.dll; do
    if [[ -e $tree/$file ]]; then cp "$tree/$file" "$release/$1/$file"; fi
  done
  cp -r "$tree/licenses" "$release/$1/licenses"
}

[[ -x $build/drape ]] || die "there is no build yet: run bash examples/quickstart.sh"
platforms=("$@")
[[ $# -gt 0 ]] || platforms=(linux64 win64)
for platform in "${platforms[@]}"; do
  [[ $platform == linux64 || $platform == win64 ]] || die "the platform is '$platform'; allowed: linux64, win64"
done
stage "Debian packages" install_debian_packages
stage "Compiler" install_compiler
link_headers
for platform in "${platforms[@]}"; do stage "Release build, $platform" build_platform "$platform"; done
ls -l "${platforms[@]/#/$release/}" | grep -E 'drape' || true
