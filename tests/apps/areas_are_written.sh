# Labels and osmAG of a map's areas: only where asked for.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o usual
[ ! -e usual/a.areas.png ] && [ ! -e usual/a.osm ] || fail "areas were not asked for"
[ -e usual/a.json ] && [ -e usual/a.roomgraph ] || fail "the usual files are missing: $(ls usual)"
expect 0 "$roomgraph" extract a.pgm -o o --format labels,osm
[ "$(cd o && echo *)" = "a.areas.png a.osm" ] || fail "names: $(ls o)"
printf 'o/a.areas.png\no/a.osm\n' | cmp - <(grep '^  ' out | sed 's/^  //')
expect 0 "$roomgraph" extract a.pgm -o all --format all
cmp all/a.areas.png o/a.areas.png
cmp all/a.osm o/a.osm
[ "$(ls all | wc -l)" -eq 14 ] || fail "not all formats: $(ls all)"

expect 0 "$roomgraph" score-rooms o/a.areas.png o/a.areas.png
[ "$(grep -cE '^(P|R|IoU) .* 100\.00 %' out)" -eq 6 ] || { cat out; fail "not all is right"; }
expect 0 "$roomgraph" info o/a.areas.png
grep -q '162 x 82 cells' out || fail "not the size of the map"
python3 - usual/a.json o/a.osm <<'P'
import json, sys, xml.etree.ElementTree as tree
graph = json.load(open(sys.argv[1]))
osm = tree.parse(sys.argv[2]).getroot()
kinds = [tag.get("v") for way in osm.findall("way") for tag in way if tag.get("k") == "osmAG:type"]
assert kinds.count("area") == len(graph["areas"]) + 1 >= 3, kinds  # and the floor
assert kinds.count("passage") == len(graph["passages"]) >= 1, kinds
P

# The labels of a.pgm and the picture of a.areas.pgm would be one file.
cp a.pgm a.areas.pgm
expect 2 "$roomgraph" extract a.pgm a.areas.pgm -o p --format png,labels
one_line err a.pgm a.areas.pgm p/a.areas.png
[ ! -e p ] || fail "a folder was made"
# Which room robots are kept out of is told by its size and its place.
expect 0 "$roomgraph" extract a.pgm -o masks --format keepout --keep-out R1
grep -qE '^  keeps robots out of R1: 1[0-9]\.[0-9] m2 at \([0-9.-]+, [0-9.-]+\)$' out || { cat out; fail "which room?"; }
