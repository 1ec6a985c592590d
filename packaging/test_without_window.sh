#!/usr/bin/env bash
# Configures without the window, from nothing and as if neither Qt nor VTK were there, builds the command line and runs its
# tests of what is installed. Also says whether the CMake that is used is the oldest that the project asks for.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install_dependencies.sh

install_dependencies
asked=$(sed -n 's/^cmake_minimum_required(VERSION \([0-9.]*\)).*/\1/p' CMakeLists.txt)
used=$(cmake --version | sed -n '1s/cmake version \([0-9]*\.[0-9]*\).*/\1/p')
if [[ $used == "$asked" ]]; then
  echo "CMake $used is the oldest that the project asks for."
else
  echo "CMake $used is used; the project asks for $asked, which was not tried here."
fi
rm -rf build/cli
options=()
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
# Not optimised: this is about what is needed, and has to be quick.
cmake --preset cli -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" -DVANTAGE_BUILD_TESTS=OFF \
  -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON "${options[@]}"
cmake --build --preset cli --target vantage-cli
tests/packaging/no_graphics_test.sh build/cli/bin/vantage-cli
tests/packaging/install_test.sh "$(command -v cmake)" "$PWD/build/cli" "$PWD" 0
