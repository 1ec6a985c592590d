#!/usr/bin/env bash
# Batches as a script runs them: several at a time, one that fails, resumed, and by GNU parallel. Usage:
# batch_test.sh VANTAGE_CLI SOURCE_DIR
set -uo pipefail
cli=$1
source_dir=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache XDG_STATE_HOME=$work/state
failures=0

fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}
# expect EXIT_CODE TEXT COMMAND...
expect() {
  local code=$1 text=$2 out got
  shift 2
  out=$("$@" 2>&1)
  got=$?
  [[ $got -eq $code ]] || { fail "exit code $got, expected $code: $*"; echo "$out" | tail -5; }
  [[ $out == *"$text"* ]] || { fail "no '$text' in the output of: $*"; echo "$out" | tail -5; }
}

mug=$source_dir/resources/objects/mug.ply
mkdir "$work/in"
cp "$source_dir/tests/screenshots/coarse_scanner.json" "$work/in/scanner.json"
{
  printf 'ply\nformat ascii 1.0\nobj_info num_cols 4\nobj_info num_rows 4\nelement vertex 16\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element range_grid 16\nproperty list uchar int vertex_indices\nend_header\n'
  for i in $(seq 0 15); do echo "$((i % 4)) $((i / 4)) 0.$((i * 7 % 10))"; done
  for i in $(seq 0 15); do echo "1 $i"; done
} >"$work/in/scan.ply"
cat >"$work/in/jobs.json" <<JSON
{ "out": "../out",
  "all": { "acquire": { "scanner": "scanner.json", "max-views": 2 }, "report": true },
  "jobs": [
    { "name": "mug", "acquire": { "object": "$mug" }, "export": [ "mug.obj", "mug.stl" ] },
    { "name": "nothing", "acquire": { "object": "nothing.ply" } },
    { "name": "scan", "import": { "range": [ "scan.ply" ], "unit": "mm" }, "export": "scan.ply" },
    { "name": "mug again", "acquire": { "object": "$mug", "seed": 7 }, "report": false } ] }
JSON
jobs=$work/in/jobs.json

expect 2 "jobs" "$cli" batch
expect 1 "cannot be read" "$cli" batch "$work/none.json"
echo '{ "jobs": [ { "name": "a", "acquire": { "objekt": "x" } } ] }' >"$work/wrong.json"
expect 1 "/jobs/0/acquire/objekt" "$cli" batch "$work/wrong.json"
[[ ! -e $work/wrong ]] || fail "a batch that was refused left a folder"
expect 0 $'mug\nnothing\nscan\nmug again' "$cli" batch "$jobs" --list
expect 1 "no job has that name" "$cli" batch "$jobs" --only nobody
expect 2 "" "$cli" batch "$jobs" --list --summary

# From elsewhere: paths are those of the file of jobs. A job that fails stops no other.
cd /
expect 1 "1 of 4 jobs failed: nothing" "$cli" batch "$jobs" --jobs 2 --threads 2
for file in mug/session.vantage mug/mug.obj mug/mug.stl mug/report.html mug/log.txt mug/job.json scan/scan.ply \
  "mug again/session.vantage" summary.csv summary.json summary.html; do
  [[ -s $work/out/$file ]] || fail "$file was not written"
done
[[ $(wc -l <"$work/out/summary.csv") -eq 5 ]] || fail "the table has not a line per job"
grep -q '^mug,done_but,4,,[0-9.]*,2,,max_views,' "$work/out/summary.csv" || { fail "mug in the table"; cat "$work/out/summary.csv"; }
grep -q '^nothing,failed,1,acquire,.*nothing.ply' "$work/out/summary.csv" || fail "what failed is not said in the table"
grep -q '^scan,done' "$work/out/summary.csv" || fail "the import in the table"
grep -q 'href="mug/report.html"' "$work/out/summary.html" || fail "the page does not lead to the report"
cmp -s "$work/out/mug/model.ply" "$work/out/mug again/model.ply" && fail "another seed gave the same model"

# The same as by hand, for any number at a time.
"$cli" acquire --object "$mug" --scanner "$work/in/scanner.json" --max-views 2 --out "$work/hand" >/dev/null 2>&1
cmp "$work/hand/model.ply" "$work/out/mug/model.ply" || fail "a batch gives another model"

# What is there stays; what is done is not done again; what failed is tried again.
expect 1 "go on with --resume" "$cli" batch "$jobs"
before=$(stat -c %Y.%i "$work/out/mug/session.vantage")
cp "$mug" "$work/in/nothing.ply"
expect 4 "done_but" "$cli" batch "$jobs" --resume
[[ $(stat -c %Y.%i "$work/out/mug/session.vantage") == "$before" ]] || fail "a job that was done was done again"
grep -q '^nothing,done_but' "$work/out/summary.csv" || fail "what failed was not tried again"
sed -i 's/"seed": 7/"seed": 8/' "$jobs"
expect 1 "was begun as another job" "$cli" batch "$jobs" --resume
sed -i 's/"seed": 8/"seed": 7/' "$jobs"

# Cancelled in the middle, and killed: it goes on to the same bytes.
for signal in TERM KILL; do
  cat >"$work/in/long.json" <<JSON
{ "out": "../$signal", "jobs": [ { "name": "a", "acquire": { "object": "$mug", "scanner": "scanner.json", "max-views": 5 } },
  { "name": "b", "acquire": { "object": "$mug", "scanner": "scanner.json", "max-views": 2 } } ] }
JSON
  "$cli" batch "$work/in/long.json" --threads 1 >"$work/log" 2>&1 &
  batch=$!
  for _ in $(seq 600); do
    grep -qs "^view 1" "$work/$signal/a/log.txt" && break
    sleep 0.05
  done
  children=$(pgrep -P $batch)
  kill -$signal $batch
  wait $batch 2>/dev/null
  code=$?
  if [[ $signal == TERM ]]; then
    [[ $code -eq 3 ]] || fail "exit code $code after SIGTERM, expected 3"
    grep -q '^a,cancelled,3,acquire' "$work/TERM/summary.csv" || fail "the table of a cancelled batch"
    grep -q '^b,not_run' "$work/TERM/summary.csv" || fail "b was begun after the stop"
  else
    # Its child goes on by itself; nobody may open its session meanwhile.
    for child in $children; do while kill -0 "$child" 2>/dev/null; do sleep 0.05; done; done
  fi
  expect 4 "done_but: 2" "$cli" batch "$work/in/long.json" --resume
done
cmp "$work/TERM/a/model.ply" "$work/KILL/a/model.ply" || fail "a batch that was stopped gives another model"

# The recipe of the manual for GNU parallel.
if command -v parallel >/dev/null; then
  "$cli" batch "$jobs" --out "$work/parallel" --list | parallel -j2 --will-cite \
    "$cli" batch "$jobs" --out "$work/parallel" --only {} --threads 1 --resume >/dev/null 2>&1
  [[ ! -e $work/parallel/summary.csv ]] || fail "a job on its own wrote a summary"
  expect 4 "done_but" "$cli" batch "$jobs" --out "$work/parallel" --summary
  cmp <(cut -d, -f1-4,6-12 "$work/out/summary.csv") <(cut -d, -f1-4,6-12 "$work/parallel/summary.csv") || fail "GNU parallel gives another table"
  cmp "$work/out/mug/model.ply" "$work/parallel/mug/model.ply" || fail "GNU parallel gives another model"
else
  echo "GNU parallel is not installed (package parallel): its recipe was not run"
fi

echo "$failures failures"
[[ $failures -eq 0 ]]
