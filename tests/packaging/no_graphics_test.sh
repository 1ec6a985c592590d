#!/usr/bin/env bash
# vantage-cli loads no library of graphics, directly or through others. Usage: no_graphics_test.sh VANTAGE_CLI
set -uo pipefail
command -v ldd >/dev/null || { echo "skipped: ldd is not installed"; exit 77; }
libraries=$(ldd "$1") || { echo "FAIL: ldd"; exit 1; }
graphics=$(grep -E 'lib(Qt[0-9]|GL|EGL|OpenGL|GLX|OSMesa|X11|xcb|vtk|wayland|drm)' <<<"$libraries")
if [[ -n $graphics ]]; then
  echo "FAIL: vantage-cli loads"
  echo "$graphics"
  exit 1
fi
echo "$(wc -l <<<"$libraries") libraries, none of graphics"
