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

# Nor does it take the place of another map's files that somebody has put there.
mkdir theirs && cd theirs
rooms plan.png
printf 'resolution: 0.05\nimage: plan.png\norigin: [3, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n' > plan.yaml
expect 0 "$roomgraph" convert plan.yaml --format gridmap -o ..
mkdir before && cp plan.* before
expect 2 "$roomgraph" convert ../plan.gridmap
one_line err "./plan.yaml: would replace a part of the map ./plan.yaml"
expect 2 "$roomgraph" extract ../plan.gridmap -o .
one_line err "./plan.png: would replace"
for file in plan.png plan.yaml; do cmp "$file" "before/$file"; done
expect 0 "$roomgraph" extract ../plan.gridmap -o . --format json
# What it has written itself, it may write again.
expect 0 "$roomgraph" convert ../plan.gridmap -o own
expect 0 "$roomgraph" convert ../plan.gridmap -o own
expect 0 "$roomgraph" extract own/plan.yaml -o . --format json
