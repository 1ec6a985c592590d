#!/usr/bin/env bash
# Installs to a prefix, moves what was installed, and runs it from there. Usage: install_test.sh CMAKE BUILD_DIR
# SOURCE_DIR WINDOW (1 when it was built)
set -uo pipefail
cmake=$1 build=$2 source_dir=$3 window=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state XDG_CONFIG_HOME=$work/config
unset VANTAGE_RESOURCES
failures=0
fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}

begin=$(date +%s.%N)
"$cmake" --install "$build" --prefix "$work/first" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
awk -v a="$begin" -v b="$(date +%s.%N)" 'BEGIN { printf "installed in %.2f s\n", b - a }'
mv "$work/first" "$work/there it is"
root="$work/there it is"
cli=$root/bin/vantage-cli
du -sh "$root" | cut -f1

# Nothing remembers where it was built or first installed.
for file in "$root"/bin/* "$root"/libexec/vantage/*; do
  [[ -f $file ]] || continue
  for place in "$work/first" "$build" "$source_dir"; do
    if strings -n 6 "$file" | grep -qF "$place"; then fail "$file names $place"; fi
  done
done
for file in share/vantage/scanners/rotating_stripe.json share/vantage/objects/mug.ply share/vantage/turntables/grbl.json \
  share/doc/vantage/manual/devices.md share/vantage/manual/operator/contents.md \
  share/vantage/manual/operator/pictures/window.png share/vantage/manual/devices.md share/man/man1/vantage-cli.1 share/bash-completion/completions/vantage-cli \
  lib/udev/rules.d/60-vantage.rules; do
  [[ -s $root/$file ]] || fail "$file was not installed"
done

grep -q '^vantage-cli [0-9]' <("$cli" --version) || fail "--version of vantage-cli"
grep -qE '^commit ([0-9a-f]{12}(-modified)?|unknown)$' <("$cli" --version) || fail "--version names no commit"
# The profiles of turntables are found beside it: an unknown one is refused with those that are.
"$cli" devices --port "$work/none" >"$work/log" 2>&1
grep -q "there is no such port" "$work/log" || { fail "devices"; cat "$work/log"; }
"$cli" acquire --object "$root/share/vantage/objects/mug.ply" --scanner "$source_dir/tests/screenshots/coarse_scanner.json" \
  --max-views 2 --out "$work/mug" >"$work/log" 2>&1
[[ $? -eq 4 ]] || { fail "the sample job"; cat "$work/log"; }
"$cli" report "$work/mug/session.vantage" --out "$work/report.html" >"$work/log" 2>&1 || { fail "the report"; cat "$work/log"; }

if [[ $window -eq 1 ]]; then
  [[ $("$root/bin/vantage" --version | head -1) == "vantage "* ]] || fail "--version of vantage, without a display"
  [[ $(grep -c '<img' "$work/report.html") -gt 0 ]] || fail "the report has no pictures"
  "$cli" render "$work/mug/session.vantage" --out "$work/mug.png" >/dev/null || fail "render"
  if command -v Xvfb >/dev/null && command -v xwd >/dev/null && command -v convert >/dev/null; then
    "$source_dir/tests/app/with_display.sh" bash -c '
      "$0/bin/vantage" "$1" & window=$!
      sleep 8
      xwd -root -silent >"$2/screen.xwd"
      kill -0 $window || exit 1
      kill $window' "$root" "$work/mug/session.vantage" "$work" || fail "the window does not stay open"
    convert "xwd:$work/screen.xwd" "${VANTAGE_INSTALL_PICTURE:-$work/screen.png}"
    colours=$(convert "xwd:$work/screen.xwd" -format %k info:)
    [[ $colours -gt 200 ]] || fail "the screen shows next to nothing: $colours colours"
  else
    echo "the window was not opened: xvfb, x11-apps or imagemagick is not installed"
  fi
else
  grep -q "has no pictures" "$work/log" || fail "it is not said that the report has no pictures"
  "$cli" render "$work/mug/session.vantage" --out "$work/mug.png" >"$work/log" 2>&1
  [[ $? -eq 1 ]] && grep -q "package vantage" "$work/log" || fail "render does not say what it needs"
fi
echo "$failures failures"
[[ $failures -eq 0 ]]
