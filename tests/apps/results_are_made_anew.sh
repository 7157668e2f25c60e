# roomgraph report makes all results of a comparison anew, byte for byte, and asks a gate again.
# The order of the maps does not matter.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps

mkdir maps
cp "$maps"/office_run[12].simplemap.gz maps
expect 0 "$roomgraph" compare maps/office_run[12].simplemap.gz -o first -q
grep -q '"relative_path":"../maps/office_run1.simplemap.gz"' first/comparison.json || fail "no place"
cp first/comparison.json .
expect 0 "$roomgraph" report comparison.json "$maps"/office_run3.simplemap.gz maps/office_run{2,1}.simplemap.gz -o again -q
for file in comparison.json comparison.runs.csv comparison.rooms.csv comparison.rooms.geojson comparison.3Dscene comparison.roomgraph report.html; do
  cmp "first/$file" "again/$file" || fail "$file is another one"
done

# Maps that lie where they were compared need no names, whatever folder the results go to.
mkdir -p a/b
expect 0 "$roomgraph" report again/comparison.json -o a/b -q
cmp first/report.html a/b/report.html || fail "the maps are not found where they were"
grep -q '"relative_path":"../../maps/office_run1.simplemap.gz"' a/b/comparison.json || fail "no place"

# Without the maps all but their pictures, which is said, and nothing drawn is replaced.
mv maps moved
expect 0 "$roomgraph" report again/comparison.json
grep -q 'office_run1' out || fail "no ranking"
grep -q 'not drawn: office_run1.simplemap.gz and office_run2.simplemap.gz: report.html, ' err ||
  fail "nothing of the maps on stderr"
cmp first/report.html again/report.html || fail "the maps were taken out of the page"
cmp first/comparison.3Dscene again/comparison.3Dscene || fail "the maps were taken out of the scene"
expect 0 "$roomgraph" report again/comparison.json -o bare
grep -q '"hasMaps":false' bare/report.html || fail "the page does not know that walls are missing"
# Those beside the comparison need no names either.
cp moved/* bare
expect 0 "$roomgraph" report bare/comparison.json -q
grep -q '"hasMaps":true' bare/report.html || fail "the maps beside the comparison are not drawn"
cmp first/comparison.runs.csv again/comparison.runs.csv

# The gate fails, and its verdict is kept.
expect 3 "$roomgraph" report again/comparison.json --fail-below 100
grep -q '"gate": {"passed":false' again/comparison.json || fail "the verdict is not saved"
grep -q 'office_run2: its score cannot be told' err || fail "no line on stderr"

echo '{"format": "roomgraph/graph"}' > other.json
expect 1 "$roomgraph" report other.json
expect 2 "$roomgraph" report comparison.json --fail-below nan
