#!/usr/bin/env bash
# From a bare Debian 12 to the sample mug: installs the packages, runs them, upgrades from the version before with a
# session there, removes everything. Needs root, debootstrap and Debian's archive. Usage: bare_debian_test.sh
# FOLDER_OF_PACKAGES SOURCE_DIR VERSION. VANTAGE_BARE_ROOT keeps the bare system for another time.
set -uo pipefail
packages=$1 source_dir=$2 version=$3
skip() {
  echo "skipped: $*"
  exit 77
}
[[ $EUID -eq 0 ]] || skip "only root may make a bare system"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
ls "$packages"/vantage_*.deb >/dev/null 2>&1 || skip "there are no packages in $packages"
mirror=${VANTAGE_DEBIAN_MIRROR:-http://deb.debian.org/debian}
failures=0
fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}
seconds_since() { awk -v a="$1" -v b="$(date +%s.%N)" 'BEGIN { printf "%.1f", b - a }'; }

work=$(mktemp -d)
root=$work/root
trap 'umount "$root/proc" 2>/dev/null; rm -rf "$work"' EXIT
if [[ -d ${VANTAGE_BARE_ROOT:-} ]]; then
  cp -a "$VANTAGE_BARE_ROOT" "$root"
else
  begin=$(date +%s.%N)
  debootstrap --variant=minbase bookworm "$root" "$mirror" >"$work/log" 2>&1 ||
    { tail -3 "$work/log"; skip "Debian's archive cannot be reached"; }
  echo "bare system in $(seconds_since "$begin") s"
  [[ -n ${VANTAGE_BARE_ROOT:-} ]] && cp -a "$root" "$VANTAGE_BARE_ROOT"
fi
mount -t proc proc "$root/proc" || skip "nothing can be mounted here"
mkdir "$root/before" "$root/now"
cp "$packages"/before/*.deb "$root/before"
cp "$packages"/*.deb "$root/now"
cp "$source_dir/tests/screenshots/coarse_scanner.json" "$root/now/scanner.json"
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 bash -c "$1"; }
size() { du -sx --block-size=1M "$root" | cut -f1; }

inside "apt-get update -q" >"$work/log" 2>&1 || skip "Debian's archive cannot be reached"
# The command line alone, of the version before.
before=$(size) begin=$(date +%s.%N)
inside "apt-get install -q -y --no-install-recommends /before/vantage-cli_*.deb /before/vantage-data_*.deb" >"$work/log" 2>&1 || { tail -5 "$work/log"; fail "vantage-cli cannot be installed"; }
echo "vantage-cli: installed in $(seconds_since "$begin") s, $(($(size) - before)) MB with all that it needs"
grep -E 'qt6|libgl1|libvtk|libx11' <<<"$(inside "dpkg -l")" && fail "graphics came with vantage-cli"
[[ -n $(inside "vantage-cli --version") ]] || fail "vantage-cli does not run"
inside "vantage-cli acquire --object /usr/share/vantage/objects/mug.ply --scanner /now/scanner.json --max-views 2 --out /root/mug" >"$work/log" 2>&1
[[ $? -eq 4 ]] || { tail -5 "$work/log"; fail "the sample job"; }
said=$(inside "vantage-cli report /root/mug/session.vantage --out /root/mug/report.html" 2>&1)
grep -q "has no pictures" <<<"$said" || fail "a report without pictures says so"
session=$(sha256sum <"$root/root/mug/session.vantage")

# Upgraded, and the window beside it.
before=$(size) begin=$(date +%s.%N)
inside "apt-get install -q -y --no-install-recommends /now/*.deb" >"$work/log" 2>&1 || { tail -5 "$work/log"; fail "the packages cannot be installed"; }
echo "all: installed in $(seconds_since "$begin") s, $(($(size) - before)) MB more with all that they need"
inside "dpkg-query -W -f '\${Version}\n' vantage-cli" | grep -qx "$version" || fail "vantage-cli was not upgraded"
[[ $(sha256sum <"$root/root/mug/session.vantage") == "$session" ]] || fail "the upgrade changed a session"
inside "vantage-cli resume /root/mug/session.vantage --set max_views=3" >"$work/log" 2>&1
[[ $? -eq 4 ]] || { tail -5 "$work/log"; fail "a session of the version before does not go on"; }
inside "vantage-cli report /root/mug/session.vantage --out /root/mug/report.html" >"$work/log" 2>&1 || { cat "$work/log"; fail "the report"; }
grep -q '<img' "$root/root/mug/report.html" || fail "the report has no pictures"
inside "vantage --version | head -1" | grep -qx "vantage $version" || fail "the window's --version"

# The window, with a session, on a display.
inside "apt-get install -q -y --no-install-recommends xvfb x11-apps libgl1-mesa-dri fonts-dejavu-core" >"$work/log" 2>&1 || fail "xvfb cannot be installed"
inside 'Xvfb :7 -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1 & server=$!
  sleep 2; export DISPLAY=:7 LIBGL_ALWAYS_SOFTWARE=1
  vantage /root/mug/session.vantage >/root/window.log 2>&1 & window=$!
  sleep 12; xwd -root -silent >/root/screen.xwd
  kill -0 $window; open=$?; kill $window $server; exit $open' || { cat "$root/root/window.log"; fail "the window does not stay open"; }
if command -v convert >/dev/null; then
  convert "xwd:$root/root/screen.xwd" "${VANTAGE_INSTALL_PICTURE:-$work/screen.png}"
  [[ $(convert "xwd:$root/root/screen.xwd" -format %k info:) -gt 200 ]] || fail "the screen shows next to nothing"
fi

inside "apt-get purge -q -y 'vantage*'" >"$work/log" 2>&1 || fail "the packages cannot be removed"
left=$(cd "$root" && find usr etc var -iname '*vantage*' ! -path 'var/cache/apt/*' ! -path 'var/lib/apt/*' ! -path 'var/log/*')
[[ -z $left ]] || fail "left behind: $left"
[[ -s $root/root/mug/session.vantage ]] || fail "the session went with the packages"
echo "$failures failures"
[[ $failures -eq 0 ]]
