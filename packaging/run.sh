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

# A folder that has no session yet: what was scanned before stays.
free_folder() {
  local folder=out/mug
  for ((i = 2; ; i++)); do
    [[ -e $folder ]] || break
    folder=out/mug-$i
  done
  echo "$folder"
}

scan_without_display() {
  build_release vantage-cli
  local out code=0
  out=$(free_folder)
  # 4: done, but not all is well; the warnings were said.
  build/release/bin/vantage-cli acquire --object resources/objects/mug.ply \
    --scanner resources/scanners/rotating_stripe.json --out "$out" --threads "$(nproc)" "$@" || code=$?
  ((code == 0 || code == 4)) || exit "$code"
  build/release/bin/vantage-cli report "$out/session.vantage" --out "$out/report.html"
  for view in model void ps-void ps-seen ps-scanner objective; do
    build/release/bin/vantage-cli render "$out/session.vantage" --view $view --out "$out/$view.png" >/dev/null
  done
  echo
  echo "There is no display; the sample mug was scanned on the command line:"
  for file in model.ply model.stl report.html report.json session.vantage {model,void,ps-void,ps-seen,ps-scanner,objective}.png; do
    if [[ -e $out/$file ]]; then echo "  $PWD/$out/$file"; fi
  done
}

install_dependencies
if [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
  open_window "$@"
else
  scan_without_display "$@"
fi
