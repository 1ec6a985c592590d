#!/usr/bin/env bash
# Builds Vantage. With a display it opens the window, with the simulated scanner and the sample mug chosen; without one it
# scans the mug on the command line until nothing is left to see, and writes model and report. Arguments go to `vantage`
# or to `vantage-cli acquire`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install_dependencies.sh
source packaging/build.sh

open_window() {
  build_release vantage
  exec build/release/bin/vantage "$@"
}

scan_without_display() {
  build_release vantage-cli
  build/release/bin/vantage-cli acquire --object resources/objects/mug.ply \
    --scanner resources/scanners/rotating_stripe.json --out out/mug --threads "$(nproc)" "$@"
  build/release/bin/vantage-cli report out/mug/session.vantage --out out/mug/report.html
  for view in model void ps-void ps-seen ps-scanner objective; do
    build/release/bin/vantage-cli render out/mug/session.vantage --view $view --out out/mug/$view.png >/dev/null
  done
  echo
  echo "There is no display; the sample mug was scanned on the command line:"
  for file in model.ply model.stl report.html report.json session.vantage {model,void,ps-void,ps-seen,ps-scanner,objective}.png; do
    if [[ -e out/mug/$file ]]; then echo "  $PWD/out/mug/$file"; fi
  done
}

install_dependencies
if [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
  open_window "$@"
else
  scan_without_display "$@"
fi
