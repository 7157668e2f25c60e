# `roomgraph carry` moves what was marked on one map to another, in the formats that it is kept in.
. "$(dirname "$0")/common.sh"

maps=$source_dir/share/roomgraph/maps
old=$maps/office_run1.simplemap.gz new=$maps/office_run2.simplemap.gz
carry() { "$roomgraph" carry "$@" --from "$old" --to "$new" --cache cache; }

expect 0 "$roomgraph" extract "$old" -q -o marked --format geojson,osm
mv marked/office_run1.geojson marked/route.geojson
mv marked/office_run1.osm marked/areas.osm
printf 'name,x,y,yaw\ndock,0,0,0\n' > marked/goals.csv
# A zone of 2 x 1 m round the dock, slower in one half.
{ printf 'P5\n60 40\n255\n'
  awk 'BEGIN { for (y = 0; y < 40; ++y) for (x = 0; x < 60; ++x)
    printf "%s", (x < 20 || x >= 40 || y < 15 || y >= 25 ? "~" : x < 30 ? "#" : "+") }' |
    tr '#+~' '\000\144\377'; } > marked/zone.pgm
printf 'image: zone.pgm\nmode: scale\nresolution: 0.1\norigin: [-3, -2, 0]\nnegate: 0\n' > marked/zone.yaml
printf 'occupied_thresh: 1.0\nfree_thresh: 0.0\nfloor: 2\n' >> marked/zone.yaml
expect 0 "$roomgraph" compare -q "$old" "$new" --reference "$old" -o c --cache cache \
  --names marked/site.json

expect 0 carry marked/goals.csv -o alone
one_line out alone/goals.csv "1 place: 1 carried"
expect 1 carry marked/route.geojson marked/areas.osm marked/goals.csv marked/zone.yaml \
  marked/site.json --via "$maps"/office_run[34].simplemap.gz -o carried
[ "$(wc -l < out)" -eq 5 ] || fail "not a line for each file"
[ "$(ls carried)" = "$(ls marked)" ] || fail "not the same files"

python3 - <<'P'
import json, math, re
goal = open("carried/goals.csv").read().split("\n")[1].split(",")
dock = (float(goal[1]), float(goal[2]))
assert goal[4] == "carried", goal

def states(things):
    return {thing["state"] for thing in things}

before, after = (json.load(open(d + "/route.geojson"))["features"] for d in ("marked", "carried"))
properties = [feature["properties"] for feature in after]
assert "carried" in states(properties) <= {"carried", "unsure", "gone", "unseen"}
nodes = {p["id"]: f["geometry"]["coordinates"] for f, p in zip(after, properties) if "frame" in p}
assert nodes
for old, new, p in zip(before, after, properties):
    assert list(old["properties"].items()) == list(p.items())[: len(old["properties"])]
    assert old["geometry"]["type"] == new["geometry"]["type"]
    if "startid" in p:  # edges lie between their nodes
        line = new["geometry"]["coordinates"][0]
        assert line[0] == nodes[p["startid"]] and line[-1] == nodes[p["endid"]]

before, after = (open(d + "/areas.osm").read() for d in ("marked", "carried"))
assert len(re.findall("<node ", before)) == len(re.findall("<node ", after))
assert re.sub(' +<tag k="(state|error_m|reason)".*\n', "", re.sub('l(at|on)=".*?"', "", after)) == \
    re.sub('l(at|on)=".*?"', "", before)
assert re.findall("<way ", after) and len(re.findall('k="state"', after)) == len(re.findall("<way ", after))

rooms = [json.load(open(d + "/site.json"))["rooms"] for d in ("marked", "carried")]
assert [r["name"] for r in rooms[0]] == [r["name"] for r in rooms[1]] and states(rooms[1])

yaml = open("carried/zone.yaml").read()
for line in ("image: zone.pgm", "mode: scale", "resolution: 0.1", "floor: 2", "occupied_thresh: 1.0"):
    assert line + "\n" in yaml, yaml
x0, y0 = map(float, re.search(r"origin: \[(.*?), (.*?), 0\]", yaml).groups())
assert len(re.findall("state: carried", yaml)) == 1
_, size, _, cells = open("carried/zone.pgm", "rb").read().split(b"\n", 3)
w, h = map(int, size.split())
for grey, least, most in ((0, 90, 110), (100, 90, 110)):
    found = [i for i, c in enumerate(cells) if c == grey]
    assert least <= len(found) <= most, (grey, len(found))
marks = [i for i, c in enumerate(cells) if c < 255]
middle = (x0 + 0.1 * (sum(i % w for i in marks) / len(marks) + 0.5),
          y0 + 0.1 * (h - sum(i // w for i in marks) / len(marks) - 0.5))
assert math.dist(middle, dock) < 0.1, (middle, dock)
P
# A mask is a map: it opens again.
expect 0 "$roomgraph" convert carried/zone.yaml -o again

# A map is carried to itself as it is, also one without scans.
expect 0 "$roomgraph" carry marked/goals.csv --from "$maps/office.gridmap.gz" --to "$maps/office.gridmap.gz" -o same
[ "$(tail -1 same/goals.csv)" = "dock,0.0000,0.0000,0.0000,carried,0.0300," ] || { cat same/goals.csv; fail "it moved"; }

# What could not be carried is named with its reason, the first ten of a file.
{ echo name,x,y; for i in $(seq 12); do echo "far$i,900,$i"; done; } > far.csv
expect 1 carry far.csv -o far
[ "$(wc -l < err)" -eq 11 ] || { cat err; fail "not a line for each of ten, and one for the rest"; }
grep -q '^roomgraph: far/far.csv: place far3: unseen: ' err || fail "it does not say what and why"
grep -q 'far.csv: and 2 more$' err || fail "it does not say how many more"

# A map that cannot be read is named once.
expect 1 "$roomgraph" carry marked/goals.csv --from "$old" --to nowhere.simplemap -o none
one_line err "nowhere.simplemap: there is no such file: check the name"

# Nothing that is read is replaced, and what cannot be read is one line.
cp marked/goals.csv before.csv
expect 2 carry marked/goals.csv -o marked
one_line err marked/goals.csv "would replace"
cmp marked/goals.csv before.csv
cp marked/zone.yaml .
expect 1 carry zone.yaml -o none
one_line err zone.yaml zone.pgm
mkdir other
cp marked/goals.csv other
expect 2 carry marked/goals.csv other/goals.csv -o none
one_line err marked/goals.csv other/goals.csv "would both be written"
for broken in '{"type":"FeatureCollection"' '<osm>' 'a,b' '{"type":"Point","coordinates":["x",1]}'; do
  printf '%s' "$broken" > broken
  expect 1 carry broken -o none
  one_line err broken
done
[ -z "$(ls none 2> /dev/null)" ] || fail "something was written"
