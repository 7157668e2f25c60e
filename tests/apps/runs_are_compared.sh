# `roomgraph compare` ranks maps of one site, leaves bad ones out, and can be a gate.
. "$(dirname "$0")/common.sh"
map=$source_dir/share/roomgraph/maps/office.gridmap.gz
cp "$map" a.gridmap.gz
cp "$map" b.gridmap.gz
cp "$map" c.gridmap.gz

expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz c.gridmap.gz -o o
grep -qE '^ +1 +c +100\.0' out || { cat out; fail "no ranking"; }
grep -q 'copies of one file' out || fail "no verdict"
[ ! -s err ] || fail "something went to stderr"
python3 - o/comparison.json <<'P'
import json, sys
result = json.load(open(sys.argv[1]))
assert result["format"] == "roomgraph/comparison" and result["version"] == 1, result
assert [r["score"] for r in result["runs"]] == [100, 100, 100], result["runs"]
assert all(r["measures"]["wall_distance"]["value"] == 0 for r in result["runs"])
assert all(r["measures"]["rooms_matched"]["value"] == 1 for r in result["runs"])
assert all(p["same_site"] for p in result["pairs"]) and len(result["pairs"]) == 3
P
[ "$(wc -l < o/comparison.runs.csv)" -eq 4 ] || fail "not a line for each run"
for file in o/*; do grep -qF "$file" out || fail "$file is not told of"; done
grep -q '^<!DOCTYPE html>' o/report.html || fail "no report"
grep -q 'copies of one file' o/report.html || fail "a report without the verdict"
grep -q 'split_at_doors.max_ratio' o/report.html || fail "a report without the options"
[ "$(gzip -dc o/comparison.3Dscene | wc -c)" -gt 10000 ] || fail "no scene"
expect 0 "$roomgraph" info o/comparison.roomgraph
grep -q 'copies of one file' out || fail "no verdict in MRPT's object"

# Neither the order nor the number of threads changes a byte.
expect 0 "$roomgraph" compare c.gridmap.gz a.gridmap.gz b.gridmap.gz -o o2 --threads 1 -q
[ ! -s out ] || fail "not quiet"
diff -r o o2

# What is kept of pairs from call to call changes no byte, and may be damaged.
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o kept --cache pairs -q
[ "$(ls pairs | wc -l)" -eq 1 ] || fail "a pair is not kept"
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz c.gridmap.gz -o kept --cache pairs -q
for file in pairs/*; do echo junk > "$file"; done
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz c.gridmap.gz -o kept2 --cache pairs -q
diff -r o kept
diff -r o kept2
grep -qx junk pairs/* && fail "a damaged pair was left"
expect 1 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o kept --cache a.gridmap.gz
one_line err a.gridmap.gz

# The frames are trusted where the user says so.
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz --aligned -o aligned
grep -q '"pose":\[0.0,0.0,0.0\]' aligned/comparison.json || fail "moved"

# A reference gets no rank.
expect 0 "$roomgraph" compare a.gridmap.gz --reference b.gridmap.gz -o reference
grep -q '"reference": "b"' reference/comparison.json || fail "no reference"

# What cannot be read, or is another building, is left out.
echo junk > junk.gridmap
expect 1 "$roomgraph" compare a.gridmap.gz junk.gridmap b.gridmap.gz -o bad
one_line err junk.gridmap
grep -q '"left_out": \[$' bad/comparison.json || fail "junk is not reported"
[ "$(wc -l < bad/comparison.runs.csv)" -eq 3 ] || fail "the rest is not compared"
rooms other.pgm
expect 0 "$roomgraph" compare a.gridmap.gz other.pgm b.gridmap.gz --resolution 0.05 -o other
[ ! -e other/site2 ] || fail "another site without being asked"
one_line err other.pgm site

# The gate.
expect 3 "$roomgraph" compare a.gridmap.gz other.pgm b.gridmap.gz -o other --fail-on not-same-site
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o gate --fail-on broken,not-same-site
expect 3 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o gate --fail-on coverage
grep -q '^roomgraph: a: its coverage cannot be told' err || { cat err; fail "passes for want of others"; }
expect 1 "$roomgraph" compare a.gridmap.gz other.pgm -o gate --fail-below 90
expect 3 "$roomgraph" compare a.gridmap.gz other.pgm -o gate --fail-on not-same-site
# Below 0 is no score, but that of a copy cannot be told, and a run may have none.
expect 3 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o gate --fail-below 0
grep -q '^roomgraph: a: its score cannot be told' err || { cat err; fail "a score of a copy"; }
expect 3 "$roomgraph" compare a.gridmap.gz other.pgm b.gridmap.gz -o gate --fail-below 0
grep -q '^roomgraph: other: has no score$' err || { cat err; fail "no score, and no complaint"; }

expect 2 "$roomgraph" compare a.gridmap.gz
expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz --fail-on nonsense
for below in 200 inf nan; do
  expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o4 --fail-below="$below"
  one_line err --fail-below "$below"
  [ ! -e o4 ] || fail "compared without a gate"
done
expect 1 "$roomgraph" compare a.gridmap.gz b.gridmap.gz --reference missing.pgm -o o3
[ ! -e o3/comparison.json ] || fail "a comparison without its reference"

# Maps of several sites are sorted where that is asked for, each into results of its own.
{ printf 'P5\n# another night\n'; tail -n +2 other.pgm; } > again.pgm
expect 0 "$roomgraph" compare again.pgm a.gridmap.gz other.pgm b.gridmap.gz c.gridmap.gz \
  --resolution 0.05 --each-site -o sites
python3 - <<'P'
import json
for folder, names in (("sites", {"a", "b", "c"}), ("sites/site2", {"again", "other"})):
    result = json.load(open(folder + "/comparison.json"))
    assert {run["name"] for run in result["runs"]} == names, (folder, result["runs"])
    assert all(run["other_site"] for run in result["left_out"])
P
for file in sites/*.* sites/site2/*; do grep -qF "$file" out || fail "$file is not told of"; done
[ ! -e sites/site3 ] || fail "a third site"
! grep -q 'other.pgm\|again.pgm' err || fail "what is compared is told to be left out"
expect 0 "$roomgraph" compare again.pgm a.gridmap.gz other.pgm b.gridmap.gz c.gridmap.gz --resolution 0.05 -o one
grep -q -- '--each-site compares each site' err || fail "no word on how to compare the other site"
expect 2 "$roomgraph" compare a.gridmap.gz other.pgm --each-site --fail-below 50 -o sites
one_line err --each-site
