# A result never takes the place of a map that it is made from.
. "$(dirname "$0")/common.sh"
rooms a.png   # a PGM in truth: maps are known by their content
cp a.png before
expect 2 "$roomgraph" extract a.png -o .
one_line err a.png
cmp a.png before

rooms b.png
printf 'image: "b.png"\nresolution: 0.05\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n' > b.yaml
expect 2 "$roomgraph" extract b.yaml -o .
one_line err b.png
cmp b.png before

expect 0 "$roomgraph" extract b.yaml a.png --output o
expect 0 "$roomgraph" extract b.yaml a.png --format json,svg -o .
cmp a.png before
