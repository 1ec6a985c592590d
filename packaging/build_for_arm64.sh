#!/usr/bin/env bash
# Cross-compiles the command line for arm64 in build/arm64 and runs the sample job with it under qemu. Installs Debian's
# cross compiler and qemu where they are missing; the libraries for arm64 are unpacked below build/arm64, the system has
# none of them. Arguments go to cmake.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install_dependencies.sh

install_dependencies
install_dependencies dependencies_arm64

# The libraries of the engine and of the command line, with all that they need, by apt's own resolver on a system that
# has nothing installed.
root=$PWD/build/arm64/root
state=$PWD/build/arm64/apt
libraries=(libc6-dev libstdc++-12-dev)
mapfile -t -O "${#libraries[@]}" libraries < <(
  sed -n '/^# Engine/,/^# Window/p' packaging/dependencies | sed -n 's/^\([a-z0-9+.-]*-dev\).*/\1/p')
wanted=$(printf '%s\n' "${libraries[@]}" | sha256sum)
if [[ $(cat "$root/complete" 2>/dev/null) != "$wanted" ]]; then
  rm -rf "$root"
  mkdir -p "$root" "$state"/{lists/partial,archives/partial}
  : >"$state/status"
  apt=(apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State="$state" -o Dir::State::status="$state/status"
    -o Dir::Cache="$state" -o Debug::NoLocking=true -o APT::Sandbox::User="$(id -un)")
  "${apt[@]}" update >&2
  "${apt[@]}" install -y --no-install-recommends --download-only "${libraries[@]}" >&2
  mkdir -p "$root"/usr/{bin,sbin,lib}
  ln -s usr/bin usr/sbin usr/lib "$root"
  for package in "$state"/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -x -C "$root" --keep-directory-symlink --no-same-owner
  done
  # Links and packages that say where their libraries are on an installed system are told where they are here.
  find "$root" -lname '/*' -printf '%p\0%l\0' | xargs -0 -n2 bash -c 'ln -sfn "$0$2" "$1"' "$root"
  find "$root/usr/lib" -path '*/cmake/*.cmake' -exec sed -i 's|\([";:]\)/usr/|\1${CMAKE_SYSROOT}/usr/|g' {} +
  echo "$wanted" >"$root/complete"
fi

export VANTAGE_ARM64_ROOT=$root PKG_CONFIG_SYSROOT_DIR=$root
export PKG_CONFIG_LIBDIR=$root/usr/lib/aarch64-linux-gnu/pkgconfig:$root/usr/share/pkgconfig
options=()
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake --preset cli -B build/arm64/cli -DCMAKE_TOOLCHAIN_FILE="$PWD/packaging/arm64.cmake" -DVANTAGE_BUILD_TESTS=OFF \
  "${options[@]}" "$@"
cmake --build build/arm64/cli --target vantage-cli

program=build/arm64/cli/bin/vantage-cli
file -b "$program"
run=(qemu-aarch64 -L "$root" "$program")
"${run[@]}" --version

# Two views of the sample mug: 4 says that the run was ended before all was seen.
sample=$(mktemp -d)
trap 'rm -rf "$sample"' EXIT
code=0
"${run[@]}" acquire --object resources/objects/mug.ply --scanner resources/scanners/rotating_stripe.json --max-views 2 \
  --out "$sample/mug" --threads 2 || code=$?
((code == 0 || code == 4)) || exit "$code"
ls -l "$sample/mug/model.ply"
