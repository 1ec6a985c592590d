#!/usr/bin/env bash
# What bash would complete. Usage: completion_test.sh COMPLETION_FILE FOLDER_OF_VANTAGE_CLI
set -uo pipefail
PATH=$2:$PATH
failures=0
compopt() { :; } # of use only while somebody types
source "$1"

# completes "WORD WORD ..." EXPECTED...: the last word is being typed.
completes() {
  local line=$1 got
  shift
  read -ra COMP_WORDS <<<"$line"
  [[ $line == *" " ]] && COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _vantage_cli
  got=" ${COMPREPLY[*]} "
  for expected in "$@"; do
    if [[ $got != *" $expected "* ]]; then
      echo "FAIL: '$line' is not completed by $expected, but by:$got"
      failures=$((failures + 1))
    fi
  done
}

completes "vantage-cli ac" acquire
completes "vantage-cli " acquire batch import resume
completes "vantage-cli --ver" --version
completes "vantage-cli acquire --obj" --object
completes "vantage-cli batch --" --jobs --resume --only --threads
completes "vantage-cli render s.vantage --view ps" ps-void ps-seen ps-scanner
completes "vantage-cli acquire --sensor si" simulated
completes "vantage-cli acquire --set planner.overlap" planner.overlap_share=
cd "$(mktemp -d)" && touch mug.vantage
completes "vantage-cli info mu" mug.vantage
completes "vantage-cli export --out mu" mug.vantage
rm -r "$PWD"
# Every command is known, and its options.
for command in $(vantage-cli --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  completes "vantage-cli $command --he" --help
done
echo "$failures failures"
[[ $failures -eq 0 ]]
