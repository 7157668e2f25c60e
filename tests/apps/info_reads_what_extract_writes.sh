# `roomgraph info` tells maps, graph files and MRPT files apart by their content.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o o
expect 0 "$roomgraph" info a.pgm
grep -q '162 x 82 cells' out || fail "no size of the map"
mv o/a.json graph.txt
mv o/a.roomgraph object.bin
expect 0 "$roomgraph" info graph.txt
tail -n +2 out > graph.info
expect 0 "$roomgraph" info object.bin
tail -n +2 out > object.info
cmp graph.info object.info

maps=$source_dir/share/roomgraph/maps
expect 0 "$roomgraph" info "$maps/office_run1.simplemap.gz"
grep -q 'key frames  120' out && grep -q 'sha256' out || fail "nothing of the run"
! grep -q 'cells' out || fail "a grid is told that nobody asked for"
expect 0 "$roomgraph" info --grid "$maps/office_run1.simplemap.gz"
grep -q '646 x 444 cells' out || fail "no grid"
expect 0 "$roomgraph" compare "$maps"/office_run[12].simplemap.gz -o compared -q
expect 0 "$roomgraph" info compared/comparison.json
tail -n +2 out > json.info
expect 0 "$roomgraph" info compared/comparison.roomgraph
tail -n +2 out > object.info
grep -q office_run2 json.info || fail "no ranking"
cmp json.info object.info

expect 1 "$roomgraph" info a.pgm missing.json graph.txt
one_line err missing.json
[ "$(grep -c ':$' out)" -ge 2 ] || fail "the other files are not told"
head -c 200 object.bin > cut.roomgraph
expect 1 "$roomgraph" info cut.roomgraph
one_line err cut.roomgraph

printf %s "{\"type\": \"FeatureCollection\", \"features\": []}" > route.geojson
# What is not of this package is told with what opens it.
expect 1 "$roomgraph" info route.geojson
one_line err "is GeoJSON, and no map"
