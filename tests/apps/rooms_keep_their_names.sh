# `roomgraph compare` tells what each run has of each room, and --names keeps ids and names.
. "$(dirname "$0")/common.sh"
map=$source_dir/share/roomgraph/maps/office.gridmap.gz
cp "$map" a.gridmap.gz
cp "$map" b.gridmap.gz

expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o --names site.json
grep -qE '^[0-9]+ rooms and [0-9]+ corridors?\.$' out || { cat out; fail "no line on the rooms"; }
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
expect 1 "$roomgraph" compare c.pgm d.pgm -o o3 --names site.json
one_line err site.json
cmp site.json edited.json
expect 2 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o3 --names a.gridmap.gz
