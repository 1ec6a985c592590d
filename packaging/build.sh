# shellcheck shell=bash
# To be sourced from the project's folder. Defines build_release, which configures the release preset and builds the
# targets it is given.

build_release() {
  local options=()
  command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  cmake --preset release "${options[@]}" >&2
  cmake --build --preset release --target "$@" >&2
}
