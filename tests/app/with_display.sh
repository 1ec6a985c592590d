#!/usr/bin/env bash
# Runs a command on a display of its own: with_display.sh COMMAND ARGUMENTS... Exits with 77 where Xvfb is missing.
set -euo pipefail
if ! command -v Xvfb >/dev/null; then
  echo "skipped: Xvfb is not installed (package xvfb)"
  exit 77
fi
display_file=$(mktemp)
Xvfb -displayfd 4 -screen 0 1920x1080x24 -nolisten tcp 4>"$display_file" 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null; rm -f "$display_file"' EXIT
for _ in $(seq 100); do
  [[ -s $display_file ]] && break
  sleep 0.1
done
DISPLAY=":$(cat "$display_file")" QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 "$@"
