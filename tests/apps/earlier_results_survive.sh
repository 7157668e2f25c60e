# A run that fails leaves the results of an earlier one as they were, and no other files.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o o
cp -r o before
head -c 3000 a.pgm > b && mv b a.pgm
expect 1 "$roomgraph" extract a.pgm -o o
diff -r o before

# A file that cannot be replaced.
rooms a.pgm
rm o/a.geojson && mkdir o/a.geojson
expect 1 "$roomgraph" extract a.pgm -o o
one_line err a.geojson
rmdir o/a.geojson
rm before/a.geojson
diff -r o before
