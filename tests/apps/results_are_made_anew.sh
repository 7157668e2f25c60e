# roomgraph report makes all results of a comparison anew, byte for byte, and asks a gate again.
# The order of the maps does not matter.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps

expect 0 "$roomgraph" compare "$maps"/office_run[12].simplemap.gz -o first -q
cp first/comparison.json .
expect 0 "$roomgraph" report comparison.json "$maps"/office_run{3,2,1}.simplemap.gz -o again -q
for file in comparison.json comparison.runs.csv comparison.rooms.csv comparison.rooms.geojson comparison.3Dscene comparison.roomgraph report.html; do
  cmp "first/$file" "again/$file" || fail "$file is another one"
done

# Without the maps all but their pictures, which is said.
expect 0 "$roomgraph" report again/comparison.json
grep -q 'office_run1' out || fail "no ranking"
grep -q 'not drawn: office_run1.simplemap.gz and office_run2.simplemap.gz: name the maps' err ||
  fail "nothing of the maps on stderr"
grep -q '"hasMaps":false' again/report.html || fail "the page does not know that walls are missing"
# Those beside the comparison need no names.
cp "$maps"/office_run[12].simplemap.gz again
expect 0 "$roomgraph" report again/comparison.json -q
cmp first/report.html again/report.html || fail "the maps beside the comparison are not drawn"
rm again/*.simplemap.gz
cmp first/comparison.runs.csv again/comparison.runs.csv

# The gate fails, and its verdict is kept.
expect 3 "$roomgraph" report again/comparison.json --fail-below 100
grep -q '"gate": {"passed":false' again/comparison.json || fail "the verdict is not saved"
grep -q 'office_run2: its score is below --fail-below' err || fail "no line on stderr"

echo '{"format": "roomgraph/graph"}' > other.json
expect 1 "$roomgraph" report other.json
expect 2 "$roomgraph" report comparison.json --fail-below nan
