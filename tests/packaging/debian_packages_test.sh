#!/usr/bin/env bash
# Makes the Debian packages of what was built, twice: the same bytes, nothing that lintian calls an error or a warning, and
# in them what is to be. Usage: debian_packages_test.sh CMAKE BUILD_DIR OUT
set -uo pipefail
cpack=$(dirname "$1")/cpack build=$2 out=$3
for tool in dpkg-deb dpkg-shlibdeps; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed (package dpkg-dev)"; exit 77; }
done
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-1767225600} LC_ALL=C.UTF-8
failures=0
fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}

rm -rf "$out"
mkdir -p "$out"
for round in 1 2; do
  (cd "$build" && "$cpack" -B "$out/$round") >"$out/log" 2>&1 || { cat "$out/log"; exit 1; }
  sleep 1 # a time that is written somewhere would differ
done
for package in "$out"/1/*.deb; do
  cmp "$package" "$out/2/$(basename "$package")" || fail "made twice, $(basename "$package") differs"
  printf '%8d KiB, installed %8d KiB: %s\n' $(($(stat -c %s "$package") / 1024)) "$(dpkg-deb -f "$package" Installed-Size)" "$(basename "$package")"
done
# A version before, to upgrade from.
(cd "$build" && "$cpack" -D CPACK_PACKAGE_VERSION=0.0.1 -B "$out/before") >"$out/log" 2>&1 || { cat "$out/log"; exit 1; }
mv "$out"/1/*.deb "$out"
rm -rf "$out/1" "$out/2"

cli=$(echo "$out"/vantage-cli_*.deb)
[[ -f $cli ]] || fail "there is no package vantage-cli"
if dpkg-deb -f "$cli" Depends | grep -Ei 'qt6|libgl|libvtk|libx11|osmesa|libegl'; then fail "vantage-cli depends on graphics"; fi
contents=$(dpkg-deb -c "$cli")
for file in usr/bin/vantage-cli usr/share/man/man1/vantage-cli.1.gz usr/share/bash-completion/completions/vantage-cli \
  usr/share/doc/vantage-cli/copyright usr/share/doc/vantage-cli/changelog.gz; do
  grep -q " ./$file\$" <<<"$contents" || fail "$file is not in vantage-cli"
done
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error,warning "$out"/*.deb || fail "lintian"
else
  echo "lintian is not installed: not asked"
fi
echo "$failures failures"
[[ $failures -eq 0 ]]
