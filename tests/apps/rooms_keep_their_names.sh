# `roomgraph compare` tells what each run has of each room, and --names keeps ids and names.
. "$(dirname "$0")/common.sh"
map=$source_dir/share/roomgraph/maps/office.gridmap.gz
cp "$map" a.gridmap.gz
cp "$map" b.gridmap.gz

expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o --names site.json
python3 - o/comparison.json site.json <<'P'
import json, sys
rooms = json.load(open(sys.argv[1]))["rooms"]
site = json.load(open(sys.argv[2]))
assert len(rooms) > 5, rooms
assert [r["id"] for r in rooms] == [r["id"] for r in site["rooms"]]
for room in rooms:
    assert [r["run"] for r in room["runs"]] == ["a", "b"], room
    for run in room["runs"]:
        assert run["sighting"] == "seen" and run["pieces"] == 1 and not run["merged"], room
        assert run["shift_m"] == 0 and run["area_change"] == 0, room
        assert run["boundary_agreement"] == 1, room
        assert run["doors_gained"] == run["doors_lost"] == 0, room
lines = open("o/comparison.rooms.csv").read().splitlines()
assert len(lines) == 1 + 2 * len(rooms), len(lines)
P

# A name that was edited stays, and nothing else changes.
sed 's/"name":"R3"/"name":"Kitchen"/' site.json > edited.json
cp edited.json site.json
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o2 --names site.json
cmp site.json edited.json
grep -q '^R3,Kitchen,room,' o2/comparison.rooms.csv || fail "the name is not used"
ls -A | grep -q part && fail "a part of a file is left"

# Where the gate fails the results have the names, but the file is left as it was, or not made.
rooms other.pgm
grep -v '"id":"R4"' edited.json > site.json   # a room less than there is
cp site.json before.json
for file in site.json none.json; do
  expect 3 "$roomgraph" compare a.gridmap.gz b.gridmap.gz other.pgm -o o4 --names "$file" \
    --fail-on not-same-site
  grep -q "^roomgraph: $file: left as it was" err || { cat err; fail "nothing said of $file"; }
  [ -s o4/comparison.rooms.csv ] || fail "no results"
done
cmp site.json before.json
[ ! -e none.json ] || fail "names of a bad night are kept"
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o4 --names site.json --fail-on broken
cmp -s site.json before.json && fail "names of a good night are not kept"

# A file that is broken, or of another site, is one line, and stays as it is.
head -c 500 edited.json > site.json
cp site.json before.json
expect 1 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o3 --names site.json
one_line err site.json JSON
cmp site.json before.json
[ ! -e o3/comparison.json ] || fail "a comparison without its names"
rooms c.pgm
rooms d.pgm
cp edited.json site.json
expect 1 "$roomgraph" compare c.pgm d.pgm --resolution 0.05 -o o3 --names site.json
one_line err site.json
cmp site.json edited.json
expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o3 --names a.gridmap.gz

# The names may not have the place of a result, whether it is there already or not.
cp -r o2 before
ln -s o2 link
for name in comparison.json comparison.runs.csv comparison.rooms.csv comparison.rooms.geojson comparison.3Dscene comparison.roomgraph report.html; do
  expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o2 --names "link/../o2/./$name"
  one_line err "$name" --names
  expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o new/er --names "$PWD/new//er/$name"
  one_line err "$name" --names
done
expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o2 --names link/report.html
diff -r o2 before
[ ! -e new ] || fail "something was written"

# A file keeps its permissions.
cp edited.json site.json
chmod 660 site.json
(umask 077 && expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o2 --names site.json)
[ "$(stat -c %a site.json)" = 660 ] || fail "other permissions"
