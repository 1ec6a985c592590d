#!/usr/bin/env bash
# Builds everything and runs all tests. The last lines are ctest's summary. Arguments go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install_dependencies.sh
source packaging/build.sh

install_dependencies
build_release all
exec ctest --preset release --parallel "$(nproc)" "$@"
