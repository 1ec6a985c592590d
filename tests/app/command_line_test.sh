#!/usr/bin/env bash
# Runs vantage-cli as a script would. Usage: command_line_test.sh VANTAGE_CLI SOURCE_DIR
set -uo pipefail
cli=$1
source_dir=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# expect EXIT_CODE TEXT COMMAND...: runs the command and looks for the text in what it prints.
expect() {
  local code=$1 text=$2
  shift 2
  local out
  out=$("$@" 2>&1)
  local got=$?
  if [[ $got -ne $code ]]; then
    echo "FAIL: exit code $got, expected $code: $*"
    echo "$out" | head -5
    failures=$((failures + 1))
  elif [[ $out != *"$text"* ]]; then
    echo "FAIL: no '$text' in the output of: $*"
    echo "$out" | head -5
    failures=$((failures + 1))
  fi
}

mug=$source_dir/resources/objects/mug.ply
scanner=$source_dir/resources/scanners/rotating_stripe.json

expect 0 "acquire" "$cli" --help
expect 0 "--strategy" "$cli" acquire --help
expect 2 "" "$cli"
expect 2 "" "$cli" fly
expect 0 "commit " "$cli" --version
expect 0 "Embree " "$cli" --version
expect 0 "--resume" "$cli" batch --help
expect 1 "cannot be read" "$cli" batch "$work/nothing.json"
expect 2 "" "$cli" acquire --object "$mug"
expect 2 "uniform" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/a" --strategy best

expect 2 "neither auto nor a number" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/a" --stands many
expect 1 "turned over" "$cli" acquire --object "$mug" --scanner "$scanner" --table hand --out "$work/a" --stands 2

expect 0 "profile" "$cli" info "$scanner"
expect 0 "mesh" "$cli" info "$mug"
expect 1 "nothing.ply" "$cli" info "$work/nothing.ply"
: >"$work/empty.ply"
expect 1 "empty.ply" "$cli" info "$work/empty.ply"
printf 'ply\nformat ascii 1.0\nelement vertex 999999999\n' >"$work/truncated.ply"
expect 1 "truncated.ply" "$cli" acquire --object "$work/truncated.ply" --scanner "$scanner" --out "$work/a"
sed 's/"breakdown_angle_deg": [0-9.]*/"breakdown_angle_deg": 95/' "$scanner" >"$work/steep.json"
expect 1 "/scanner/breakdown_angle_deg" "$cli" acquire --object "$mug" --scanner "$work/steep.json" --out "$work/a"
expect 1 "first-view" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/a" --first-view 900

expect 4 "2 views" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/run" --max-views 2
expect 0 "4 done, but" "$cli" --help
for file in session.vantage model.ply model.stl report.json; do
  [[ -s $work/run/$file ]] || { echo "FAIL: $file was not written"; failures=$((failures + 1)); }
done
expect 0 "session" "$cli" info "$work/run/session.vantage"
expect 0 "next best view" "$cli" plan "$work/run/session.vantage"
expect 0 "0: down" "$cli" stand "$work/run/session.vantage"
expect 1 "no stand to align" "$cli" align "$work/run/session.vantage"
cp "$work/run/session.vantage" "$work/turned.vantage"
expect 1 "has sides 0 to" "$cli" stand "$work/turned.vantage" --face 99
expect 0 '"stand": 1' "$cli" stand "$work/turned.vantage" --face 0 --json
expect 0 "stands_not_aligned: 1" "$cli" info "$work/turned.vantage"
expect 0 "triangles" "$cli" export "$work/turned.vantage" --out "$work/turned.obj"
expect 1 "no view yet" "$cli" align "$work/turned.vantage" --stand 1
expect 0 '"asked"' "$cli" plan "$work/run/session.vantage" --position 3 --json
expect 0 "triangles" "$cli" export "$work/run/session.vantage" --out "$work/run/model.obj"
expect 0 "open: " "$cli" export "$work/run/session.vantage" --out "$work/run/model.obj"
expect 0 '"openings": ' "$cli" export "$work/run/session.vantage" --out "$work/run/model.obj" --json
expect 1 "model.xyz" "$cli" export "$work/run/session.vantage" --out "$work/run/model.xyz"
expect 1 "cannot be printed as one piece: it has " "$cli" export "$work/run/session.vantage" --printable --out "$work/p.stl"
[[ ! -e $work/p.stl ]] || { echo "FAIL: a model that cannot be printed was written"; failures=$((failures + 1)); }
expect 0 '"printable": true' "$cli" export "$work/run/session.vantage" --close-holes all --pieces largest --printable --units inch --out "$work/p.3mf" --json
expect 0 "p.3mf" "$cli" info "$work/p.3mf"
expect 0 "mm² of the surface are invented" "$cli" export "$work/run/session.vantage" --close-holes all --out "$work/p.ply"
grep -qa "property uchar invented" "$work/p.ply" || { echo "FAIL: a closed model does not mark what is invented"; failures=$((failures + 1)); }
expect 0 "does not tell what is invented" "$cli" export "$work/run/session.vantage" --close-holes all --out "$work/p.stl"
expect 0 "left open, the widest" "$cli" export "$work/run/session.vantage" --close-holes 0.01 --out "$work/p.stl"
expect 0 '"error_greatest_mm": 0.0' "$cli" export "$work/run/session.vantage" --error 0.05 --out "$work/p.obj" --json
expect 0 "measured both ways" "$cli" export "$work/run/session.vantage" --max-triangles 900 --out "$work/p.obj"
expect 0 "aligned to three points" "$cli" export "$work/run/session.vantage" --align 0,0,10 10,0,10 0,10,10 --out "$work/p.obj"
expect 1 "on one line" "$cli" export "$work/run/session.vantage" --align 0,0,0 1,0,0 2,0,0 --out "$work/p.obj"
expect 0 "not closed" "$cli" measure "$work/run/session.vantage" --section 0,0,1,30
expect 0 '"distance_mm": ' "$cli" measure "$work/run/session.vantage" --points 50,0,30 0,50,30 --plane 0,0,1,0 --json
expect 0 "circle:  diameter" "$cli" measure "$work/run/session.vantage" --points 50,0,30 0,50,30 -50,0,30
expect 0 "enclosed with what is invented" "$cli" measure "$work/p.ply"
expect 1 "need points" "$cli" measure "$work/p.ply" --plane 0,0,1,0
expect 2 "is no plane" "$cli" measure "$work/p.ply" --section 0,0,0,1
expect 2 "is no point" "$cli" measure "$work/p.ply" --points 1,2
for wrong in "--close-holes -1" "--close-holes some" "--pieces 0" "--max-triangles 0" "--error 0" "--error nan" "--units mile"; do
  expect 2 "" "$cli" export "$work/run/session.vantage" $wrong --out "$work/p.stl"
done
expect 0 "covered" "$cli" evaluate "$work/run/session.vantage" --object "$mug" --scanner "$scanner"

# Nothing that is there is lost.
sum() { sha256sum "$1" | cut -d' ' -f1; }
before=$(sum "$work/run/session.vantage")
expect 1 "say --replace" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/run" --max-views 1
{
  printf 'ply\nformat ascii 1.0\nobj_info num_cols 4\nobj_info num_rows 4\nelement vertex 16\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element range_grid 16\nproperty list uchar int vertex_indices\nend_header\n'
  for i in $(seq 0 15); do echo "$((i % 4)) $((i / 4)) 0.$((i * 7 % 10))"; done
  for i in $(seq 0 15); do echo "1 $i"; done
} >"$work/scan.ply"
scan_before=$(sum "$work/scan.ply")
expect 1 "resume" "$cli" import "$work/scan.ply" --unit mm --session "$work/run/session.vantage"
expect 1 "is no session" "$cli" import "$work/scan.ply" --unit mm --session "$work/scan.ply" --replace
[[ $(sum "$work/scan.ply") == "$scan_before" ]] || { echo "FAIL: a scan was replaced"; failures=$((failures + 1)); }
[[ $(sum "$work/run/session.vantage") == "$before" ]] || { echo "FAIL: a session was changed"; failures=$((failures + 1)); }
expect 1 "empty.ply" "$cli" import "$work/empty.ply" --session "$work/run/session.vantage" --replace
[[ $(sum "$work/run/session.vantage") == "$before" ]] || { echo "FAIL: a failing import replaced a session"; failures=$((failures + 1)); }
expect 0 "written" "$cli" import "$work/scan.ply" --unit mm --session "$work/recorded.vantage"
expect 1 "has no scanner profile" "$cli" resume "$work/recorded.vantage"
mkdir "$work/models"
cp "$mug" "$work/models/model.ply"
expect 1 "model.ply: is there already" "$cli" acquire --object "$work/models/model.ply" --scanner "$scanner" --out "$work/models"
expect 1 "is read by this command" "$cli" acquire --object "$work/models/model.ply" --scanner "$scanner" --out "$work/models" --replace
expect 1 "is read by this command" "$cli" export "$work/run/session.vantage" --out "$work/run/session.vantage"
cp "$scanner" "$work/mine.json"
expect 1 "is not replaced" "$cli" options --write "$work/mine.json"
expect 1 "no regular file" "$cli" report "$work/run/session.vantage" --out /dev/null
expect 1 "is not replaced" "$cli" report "$work/run/session.vantage" --out "$work/mine.json"
expect 1 "is not replaced" "$cli" render "$work/run/session.vantage" --out "$work/mine.json"
cmp "$mug" "$work/models/model.ply" && cmp "$scanner" "$work/mine.json" || failures=$((failures + 1))
expect 1 "empty.ply" "$cli" acquire --object "$work/empty.ply" --scanner "$scanner" --out "$work/never/made"
[[ ! -e $work/never ]] || { echo "FAIL: a folder was made for nothing"; failures=$((failures + 1)); }
expect 1 "leave --frame" "$cli" import "$work/empty.ply" --scanner "$scanner" --frame y+ --session "$work/framed.vantage"
# An object out of sight: no session is left that nobody could go on with.
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n9000 0 0\n9050 0 0\n9000 50 50\n3 0 1 2\n' >"$work/away.ply"
expect 1 "has no surface" "$cli" acquire --object "$work/away.ply" --scanner "$scanner" --out "$work/away"
[[ ! -e $work/away ]] || { echo "FAIL: a session without a view was left"; failures=$((failures + 1)); }
# Who cannot turn the table somewhere is not asked to turn it there again.
for turn in 1 2 3 4 5; do printf 'done\nskip\n'; done |
  "$cli" acquire --object "$mug" --scanner "$scanner" --table hand --events --max-views 4 --out "$work/hand" >"$work/turns" 2>&1
asked=$(grep '"event":"turn"' "$work/turns" | sed 's/.*"position":\([0-9]*\).*/\1/')
[[ $(wc -l <<<"$asked") -ge 5 && -z $(sort <<<"$asked" | uniq -d) ]] || { echo "FAIL: asked to turn to" $asked; failures=$((failures + 1)); }
cp -r "$work/run" "$work/replaced"
expect 4 '"code": "ended_early"' "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/replaced" --max-views 1 --replace --json
expect 0 "views: 1" "$cli" info "$work/replaced/session.vantage"
[[ $(find "$work/replaced" -name '*.vantage' | wc -l) -eq 1 ]] || { echo "FAIL: the replaced session is still there"; failures=$((failures + 1)); }

# Same input, same bytes, for any number of threads.
"$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/one" --max-views 2 --threads 1 >/dev/null 2>&1
cmp "$work/run/model.ply" "$work/one/model.ply" || failures=$((failures + 1))

# Interrupted, and left by its terminal: exit code 3, and a session that opens.
for signal in INT HUP; do
  "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/stopped-$signal" >"$work/log" 2>&1 &
  pid=$!
  for _ in $(seq 100); do
    grep -q "^view 1" "$work/log" && break
    sleep 0.1
  done
  kill -$signal $pid
  wait $pid
  code=$?
  [[ $code -eq 3 ]] || { echo "FAIL: exit code $code after SIG$signal, expected 3"; failures=$((failures + 1)); }
  expect 0 "session" "$cli" info "$work/stopped-$signal/session.vantage"
done

# What cannot be written is said: standard output, and a file that may not grow.
expect 1 "standard output" bash -c "'$cli' info '$mug' >/dev/full"
expect 1 "standard output" bash -c "'$cli' --help >/dev/full"
expect 1 "cannot be written" bash -c "ulimit -f 64; '$cli' export '$work/stopped-HUP/session.vantage' --out '$work/small.ply'"
[[ -e $work/small.ply ]] && { echo "FAIL: half a model was left"; failures=$((failures + 1)); }
expect 1 "" bash -c "ulimit -f 64; '$cli' acquire --object '$mug' --scanner '$scanner' --out '$work/limited'"
[[ -z $(find "$work" -name "*.part" -o -name "*.new") ]] || { echo "FAIL: unfinished files are left"; failures=$((failures + 1)); }

# A scanner of very many rays says what it takes before the work begins.
sed -E 's/("samples_per_stripe": )[0-9]+/\12000/; s/("stripes": )[0-9]+/\12000/' "$scanner" >"$work/large.json"
expect 1 "4.0 million rays: this takes about 0.4 GB of memory, about 44 MB more with every scan" "$cli" acquire --object "$mug" --scanner "$work/large.json" --out "$work/large" --first-view 9999

# Killed: the run goes on to the same bytes, with the object's file gone. Nobody may open the session meanwhile.
cp "$mug" "$work/mug.ply"
"$cli" acquire --object "$work/mug.ply" --scanner "$scanner" --out "$work/whole" --max-views 5 >/dev/null 2>&1
"$cli" acquire --object "$work/mug.ply" --scanner "$scanner" --out "$work/killed" --max-views 5 >"$work/log" 2>&1 &
pid=$!
for _ in $(seq 1000); do
  grep -q "^view 1" "$work/log" && break
  sleep 0.02
done
kill -STOP $pid # it would go on, and be done, while the others look at its session
expect 1 "vantage-cli (process $pid" "$cli" resume "$work/killed/session.vantage"
expect 0 "running" "$cli" info "$work/killed/session.vantage"
kill -KILL $pid
wait $pid 2>/dev/null
rm "$work/mug.ply"
expect 4 "5 views" "$cli" resume "$work/killed/session.vantage"
cmp "$work/whole/model.ply" "$work/killed/model.ply" || failures=$((failures + 1))
expect 4 "5 views" "$cli" resume "$work/killed/session.vantage" --out "$work/again"
cmp "$work/whole/model.ply" "$work/again/model.ply" || failures=$((failures + 1))
expect 1 "no such file" "$cli" resume "$work/nothing.vantage"

# Positions that nobody planned: just these, also beyond the end that the limit set.
expect 1 "position 90, the workspace has positions 0 to 89" "$cli" resume "$work/killed/session.vantage" --positions 12,90
expect 1 "position -1" "$cli" resume "$work/killed/session.vantage" --positions=-1
expect 2 "" "$cli" resume "$work/killed/session.vantage" --positions twelve
cp "$work/killed/session.vantage" "$work/forced.vantage"
expect 4 "7 views" "$cli" resume "$work/forced.vantage" --positions 12,40 --out "$work/forced"
expect 0 '"position": 40' cat "$work/forced/report.json"
expect 4 "7 views" "$cli" resume "$work/forced.vantage" --out "$work/forced"

# Options: what is listed can be set, what cannot be is refused with key, value and expectation.
expect 0 "--port" "$cli" devices --help
expect 1 "there is no such port" "$cli" devices --port "$work/no_port"
expect 1 '"kind": "serial"' "$cli" devices --port "$work/no_port" --json
expect 1 "is no serial port" "$cli" devices --port "$mug"

expect 0 "planner.overlap_share=0.1" "$cli" options
expect 0 '"key": "planner.overlap_share"' "$cli" options --json
expect 0 "planner.overlap_share=0.25" "$cli" options --set planner.overlap_share=0.25
expect 2 "planner.overlap_share is 7, expected a number from 0 to 1" "$cli" options --set planner.overlap_share=7
expect 2 "the nearest is planner.overlap_share" "$cli" options --set planner.overlapshare=0.2
expect 2 "expected key=value" "$cli" options --set planner.overlap_share
expect 2 "expected no more than registration.coarse_gate" "$cli" options --set registration.final_gate=12 --set registration.coarse_gate=10
expect 2 "max_views is 0" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/a" --max-views 0
expect 2 "max_views is 0" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/a" --set max_views=0
settings=()
while read -r line; do [[ $line == *=* && $line != simulation.object=* ]] && settings+=(--set "$line"); done < <("$cli" options | grep -v "^[ #]")
expect 0 "planner.overlap_share=0.1" "$cli" options "${settings[@]}"
expect 0 "written" "$cli" options --set max_views=2 --set planner.tolerance=0.3 --write "$work/options.json"
expect 0 "planner.tolerance=0.3" "$cli" options --options "$work/options.json"
echo '{ "max_views": "many" }' >"$work/wrong.json"
expect 2 "wrong.json: max_views is many" "$cli" options --options "$work/wrong.json"
expect 1 "nothing.json" "$cli" options --options "$work/nothing.json"
expect 4 "1 views" "$cli" acquire --object "$mug" --scanner "$scanner" --out "$work/set" --options "$work/options.json" --set max_views=1
expect 0 "planner.tolerance=0.3" "$cli" options "$work/set/session.vantage"
expect 2 "as the session was begun" "$cli" resume "$work/set/session.vantage" --set triangulation.angle_slack=3
expect 4 "2 views" "$cli" resume "$work/set/session.vantage" --set max_views=2
expect 0 "max_views=2" "$cli" options "$work/set/session.vantage"

# What is not the object: said before it is done, erased, listed, and taken back to the same bytes.
expect 2 "" "$cli" erase
expect 2 "is no plane" "$cli" erase "$work/whole/session.vantage" --below 0,0,1
expect 2 "is no box" "$cli" erase "$work/whole/session.vantage" --box 0,0,0,1,1,0
expect 2 "at a time" "$cli" erase "$work/whole/session.vantage" --below 0,0,1,5 --loose-pieces 10
expect 1 "no such file" "$cli" erase "$work/nothing.vantage"
cp "$work/whole/session.vantage" "$work/erased.vantage"
expect 0 "nothing is erased" "$cli" erase "$work/erased.vantage"
expect 0 "would erase" "$cli" erase "$work/erased.vantage" --below 0,0,1,20 --preview
cmp "$work/whole/session.vantage" "$work/erased.vantage" || { echo "FAIL: a preview changed the session"; failures=$((failures + 1)); }
expect 1 "nothing of the object would be left" "$cli" erase "$work/erased.vantage" --below 0,0,1,1000
expect 1 "has not stood in stand 4" "$cli" erase "$work/erased.vantage" --below 0,0,1,20 --stand 4
expect 0 "--take-back 0" "$cli" erase "$work/erased.vantage" --below 0,0,1,20
expect 0 "erasure 0: below, in stand 0" "$cli" erase "$work/erased.vantage"
expect 4 "it holds for later scans" "$cli" erase "$work/erased.vantage" --below 0,0,1,20
expect 0 '"kind": "box"' "$cli" erase "$work/erased.vantage" --box 25,-60,30,70,60,60 --json
expect 4 '"code": "nothing_erased"' "$cli" erase "$work/erased.vantage" --loose-pieces 0 --json
echo '{ "kind": "near", "points": [0, 0, 40], "radius_mm": 60 }' >"$work/region.json"
expect 0 '"samples"' "$cli" erase "$work/erased.vantage" --region "$work/region.json" --preview --json
echo '{ "kind": "sphere" }' >"$work/region.json"
expect 1 "region.json is damaged" "$cli" erase "$work/erased.vantage" --region "$work/region.json"
expect 0 "erased" "$cli" report "$work/erased.vantage" --out "$work/erased.html"
expect 0 "Erasure 2 taken back" "$cli" erase "$work/erased.vantage" --take-back 2
expect 1 "there is no erasure 2" "$cli" erase "$work/erased.vantage" --take-back 2
expect 0 "triangles" "$cli" export "$work/erased.vantage" --out "$work/erased.stl"

# Assisted steps: range files that the operator brings.
expect 2 "--position" "$cli" step "$work/whole/session.vantage" --range "$work/nothing.ply"
expect 1 "nothing.ply" "$cli" step "$work/whole/session.vantage" --range "$work/nothing.ply" --position 3
expect 1 "workspace" "$cli" step "$work/whole/session.vantage" --range "$work/nothing.ply" --position 9000

echo "$failures failures"
[[ $failures -eq 0 ]]
