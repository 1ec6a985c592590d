#!/usr/bin/env bash
# Draws every view of a short session on the command line, twice: the same bytes each time, and errors that say why.
# Arguments: vantage-cli, source folder.
set -euo pipefail
cli=$1
source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY
export XDG_CACHE_HOME=$folder/cache

fail() {
  echo "$*" >&2
  exit 1
}

# The exit code of a command; its messages go to $folder/messages.
code_of() {
  local code=0
  "$@" >/dev/null 2>"$folder/messages" || code=$?
  echo "$code"
}

"$cli" acquire --object "$source/resources/objects/mug.ply" --scanner "$source/tests/screenshots/coarse_scanner.json" \
  --out "$folder/mug" --max-views 2 >/dev/null 2>&1 || [[ $? -eq 4 ]] # two views are not all
session=$folder/mug/session.vantage
for view in model void ps-void ps-seen ps-scanner objective; do
  for run in 1 2; do
    "$cli" render "$session" --view $view --out "$folder/$view$run.png" --size 320x240 >/dev/null
  done
  cmp "$folder/${view}1.png" "$folder/${view}2.png" || fail "$view: two runs gave different bytes"
  # A picture of one colour is a few hundred bytes.
  [[ $(stat -c %s "$folder/${view}1.png") -gt 3000 ]] || fail "$view: the picture shows next to nothing"
done
"$cli" render "$session" --view model --step 1 --out "$folder/step.png" --size 320x240 >/dev/null
cmp -s "$folder/step.png" "$folder/model1.png" && fail "--step 1 shows the last step"

[[ $(code_of "$cli" render "$session" --step 9 --out "$folder/x.png") == 1 ]] || fail "--step 9: expected exit code 1"
grep -q -- "--step is 9" "$folder/messages" || fail "--step 9: the message does not name it"
[[ $(code_of "$cli" render "$session" --view nothing --out "$folder/x.png") == 2 ]] || fail "--view nothing: expected 2"
"$cli" render "$session" --surface plain --out "$folder/plain.png" --size 320x240 >/dev/null
cmp "$folder/plain.png" "$folder/model1.png" || fail "a model without colours is not plain by itself"
"$cli" render "$session" --surface age --out "$folder/age.png" --size 320x240 >/dev/null
cmp -s "$folder/age.png" "$folder/model1.png" && fail "--surface age shows nothing else"
[[ $(code_of "$cli" render "$session" --surface colours --out "$folder/x.png") == 1 ]] || fail "--surface colours: expected 1"
grep -q "none of its scans has colours" "$folder/messages" || fail "--surface colours: the message does not say why"
[[ $(code_of "$cli" render "$session" --size 5x5 --out "$folder/x.png") == 1 ]] || fail "--size 5x5: expected 1"
[[ $(code_of "$cli" render "$session" --out "$folder/no/x.png") == 1 ]] || fail "a folder that is missing: expected 1"
echo "all views drawn"
