#!/usr/bin/env bash
# Desktop file, metainfo, MIME type and icons as their tools judge them. Usage: desktop_files_test.sh SOURCE_DIR VERSION
set -uo pipefail
source_dir=$1
desktop=$1/packaging/desktop
failures=0
run=0

check() {
  local tool=$1
  if ! command -v "$tool" >/dev/null; then
    echo "not checked: $tool is not installed"
    return
  fi
  run=$((run + 1))
  "$@" || failures=$((failures + 1))
}

check desktop-file-validate "$desktop/vantage.desktop"
check appstreamcli validate --no-net --pedantic "$desktop"/*.metainfo.xml
check xmllint --noout "$desktop/vantage-session.xml" "$source_dir"/resources/icons/*.svg
if command -v update-mime-database >/dev/null; then
  mime=$(mktemp -d)
  mkdir "$mime/packages"
  cp "$desktop/vantage-session.xml" "$mime/packages"
  check update-mime-database "$mime"
  grep -q 'application/x-vantage-session' "$mime/globs2" || { echo "FAIL: *.vantage has no type"; failures=$((failures + 1)); }
  rm -r "$mime"
fi
# Tables that are kept in step by hand.
grep -q "<release version=\"$2\"" "$desktop"/*.metainfo.xml || { echo "FAIL: the metainfo does not know version $2"; failures=$((failures + 1)); }
type=$(sed -n 's/.*mime-type type="\([^"]*\)".*/\1/p' "$desktop/vantage-session.xml")
for file in "$desktop/vantage.desktop" "$desktop"/*.metainfo.xml; do
  grep -q "$type" "$file" || { echo "FAIL: $file does not name $type"; failures=$((failures + 1)); }
done
[[ -e $source_dir/resources/icons/${type/\//-}.svg ]] || { echo "FAIL: there is no icon for $type"; failures=$((failures + 1)); }

echo "$run tools, $failures failures"
((failures == 0)) || exit 1
((run > 0)) || { echo "skipped: none of the tools is installed (desktop-file-utils, appstream, libxml2-utils)"; exit 77; }
