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
one_line err "./plan.yaml: would replace a file that roomgraph has not written"
expect 2 "$roomgraph" extract ../plan.gridmap -o .
one_line err "./plan.png: would replace a part of the map ./plan.yaml"
for file in plan.png plan.yaml; do cmp "$file" "before/$file"; done
expect 0 "$roomgraph" extract ../plan.gridmap -o . --format json
# What it has written itself, it may write again.
expect 0 "$roomgraph" convert ../plan.gridmap -o own
expect 0 "$roomgraph" convert ../plan.gridmap -o own
expect 0 "$roomgraph" extract own/plan.yaml -o . --format json

# Nor any other yaml, picture, grid map or log, even where no map names it.
cd .. && mkdir alone && cd alone
gunzip < ../plan.gridmap > plan.gridmap   # the mark of its author goes with the compression
printf 'planner: true\n' > plan.yaml
rooms plan.pgm && cp plan.pgm plan.png && cp plan.pgm plan.rawlog
mkdir before && cp plan.* before
for format in ros gridmap png; do
  expect 2 "$roomgraph" convert ../theirs/plan.yaml --format $format
  one_line err "would replace a file that roomgraph has not written"
done
rm plan.yaml   # a bare picture is nobody's but the user's, either
expect 2 "$roomgraph" convert ../plan.gridmap
one_line err "./plan.pgm: would replace a file that roomgraph has not written"
expect 2 "$roomgraph" extract ../plan.gridmap -o . --format json,png
one_line err "./plan.png: would replace a file that roomgraph has not written"
gunzip -c "$source_dir/share/roomgraph/maps/office.simplemap.gz" > ../plan.simplemap
expect 2 "$roomgraph" export-rawlog ../plan.simplemap
one_line err "./plan.rawlog: would replace a file that roomgraph has not written"
for file in before/plan.pgm before/plan.png before/plan.gridmap before/plan.rawlog; do
  cmp "$file" "$(basename "$file")"
done

# Its own it writes again, in each format.
for format in ros gridmap png; do
  for time in first second; do
    expect 0 "$roomgraph" convert ../theirs/plan.yaml --format $format -o again
  done
done
for time in first second; do
  expect 0 "$roomgraph" extract ../plan.gridmap --format all -o graph
  expect 0 "$roomgraph" export-rawlog ../plan.simplemap -o log
done
