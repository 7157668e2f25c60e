# `roomgraph merge` makes one map of several runs, with the names that the rooms have.
. "$(dirname "$0")/common.sh"

maps=$source_dir/share/roomgraph/maps
merge() { "$roomgraph" merge "$@" -o site --cache cache; }

expect 0 merge "$maps"/office_run[1234].simplemap.gz --names names.json
grep -q "not aligned" err && fail "a run whose place is sure is said to be elsewhere"
for file in simplemap.gz gridmap.gz yaml pgm runs.png age.png graph.json graph.svg graph.geojson \
  graph.osm; do
  [ -s site/site.$file ] || fail "no $file"
  grep -qx "site/site.$file" out || fail "$file is not told"
done
expect 0 "$roomgraph" info site/site.simplemap.gz
expect 0 "$roomgraph" convert site/site.yaml -o again

# A name that somebody has given is in all files of the next call; one given twice gets the id.
sed -i 's/"name":"R1"/"name":"Kitchen <1>"/; s/"name":"R[23]"/"name":"Office"/' names.json
cp names.json edited.json
expect 0 merge "$maps"/office_run[1234].simplemap.gz --names names.json
cmp names.json edited.json || fail "names are not kept"
python3 - <<'P'
import hashlib, json, xml.etree.ElementTree as xml
source = json.load(open("site/site.graph.json"))["input"]
assert (source["file"], source["kind"]) == ("site.gridmap.gz", "gridmap"), source
assert source["sha256"] == hashlib.sha256(open("site/site.gridmap.gz", "rb").read()).hexdigest()
names = {"Kitchen <1>", "Office (R2)", "Office (R3)"}
areas = [area["name"] for area in json.load(open("site/site.graph.json"))["areas"]]
assert names < set(areas) and len(set(areas)) == len(areas), areas
rooms = [f["properties"]["name"] for f in json.load(open("site/site.graph.geojson"))["features"]
         if "name" in f["properties"]]
assert names < set(rooms) < set(areas), rooms
tags = [(t.get("k"), t.get("v")) for t in xml.parse("site/site.graph.osm").getroot().iter("tag")]
assert {("name", n) for n in names} < set(tags)
assert {v for k, v in tags if k in ("osmAG:from", "osmAG:to")} <= set(areas)
P
expect 2 merge "$maps"/office_run1.simplemap.gz
one_line err "two or more"
printf '{}' > names.json
expect 1 merge "$maps"/office_run[12].simplemap.gz --names names.json
one_line err names.json

# A copy bears nothing out, and what cannot be read is missing from the map.
cp "$maps"/office_run1.simplemap.gz latest.simplemap.gz
expect 1 merge "$maps"/office_run1.simplemap.gz latest.simplemap.gz
grep -q "is a copy of .*: left out" err || fail "a copy counts as another run"
head -c 2000 latest.simplemap.gz > cut.simplemap.gz
expect 1 "$roomgraph" repair "$maps"/office_run[12].simplemap.gz cut.simplemap.gz -o rest --cache cache
one_line err cut.simplemap.gz "cut short"
[ -s rest/site.g2o ] || fail "the others are not used"
