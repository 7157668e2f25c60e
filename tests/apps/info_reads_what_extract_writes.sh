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

expect 1 "$roomgraph" info a.pgm missing.json graph.txt
one_line err missing.json
[ "$(grep -c ':$' out)" -ge 2 ] || fail "the other files are not told"
head -c 200 object.bin > cut.roomgraph
expect 1 "$roomgraph" info cut.roomgraph
one_line err cut.roomgraph
