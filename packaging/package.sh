#!/usr/bin/env bash
# Makes the Debian packages vantage, vantage-cli, vantage-data and vantage-doc in build/package/packages, and prints their
# names. The same commit gives the same bytes, wherever and whenever they are made. Arguments go to cmake.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install_dependencies.sh

if [[ -z ${SOURCE_DATE_EPOCH:-} ]]; then
  SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null) ||
    { echo "These sources are no repository: say their time in SOURCE_DATE_EPOCH." >&2; exit 1; }
fi
export SOURCE_DATE_EPOCH LC_ALL=C.UTF-8 TZ=UTC

# Hardened as Debian's own packages, without a trace of the folder that it was built in.
export DEB_BUILD_MAINT_OPTIONS=hardening=+all,-branch DEB_CFLAGS_MAINT_STRIP=-g DEB_CXXFLAGS_MAINT_STRIP=-g
CXXFLAGS="$(dpkg-buildflags --get CXXFLAGS) $(dpkg-buildflags --get CPPFLAGS) -ffile-prefix-map=$PWD=. ${CXXFLAGS:-}"
CFLAGS="$(dpkg-buildflags --get CFLAGS) $(dpkg-buildflags --get CPPFLAGS) -ffile-prefix-map=$PWD=. ${CFLAGS:-}"
LDFLAGS="$(dpkg-buildflags --get LDFLAGS) ${LDFLAGS:-}"
export CXXFLAGS CFLAGS LDFLAGS

install_dependencies
options=()
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake --preset package "${options[@]}" "$@" >&2
cmake --build --preset package >&2
rm -rf build/package/packages
(cd build/package && cpack >&2)
ls "$PWD"/build/package/packages/*.deb
