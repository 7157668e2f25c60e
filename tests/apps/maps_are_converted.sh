# Maps are written in other formats, and read back as the same cells.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" convert a.pgm --resolution 0.04 -o ros
[ "$(cat out)" = "ros/a.yaml
ros/a.pgm" ] || fail "not the names of what is written"
expect 0 "$roomgraph" convert ros/a.yaml -o mrpt --format gridmap
expect 0 "$roomgraph" convert mrpt/a.gridmap -o png --format png
cells() { "$roomgraph" info "$@" 2>&1 | grep '^cells' > cells || fail "no cells in $*"; cat cells; }
for map in ros/a.yaml mrpt/a.gridmap png/a.png; do
  [ "$(cells "$map")" = "$(cells a.pgm)" ] || fail "$map has other cells"
done
"$roomgraph" info mrpt/a.gridmap | grep -q '^resolution  0.04 m' || fail "the resolution is lost"

# A bare picture without a scale says so.
expect 0 "$roomgraph" convert a.pgm -o b
one_line err a.pgm "0.05 m per cell"

expect 2 "$roomgraph" convert a.pgm --format tiff
one_line err tiff "ros, gridmap or png"
expect 2 "$roomgraph" convert a.pgm -o . --format ros
one_line err a.pgm "would replace"
expect 1 "$roomgraph" convert none.pgm a.pgm -o c --format png
[ -f c/a.png ] || fail "a map that can be read is not written"
