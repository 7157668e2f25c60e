# stdout has the results only; --quiet leaves it empty, and logs go to stderr.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o o --format json,svg
printf 'o/a.json\no/a.svg\n' | cmp - <(grep '^  ' out | sed 's/^  //')
sed -n 1p out | grep -q '^a.pgm: 2 rooms' || fail "first line: $(sed -n 1p out)"

expect 0 "$roomgraph" extract a.pgm -o o --quiet
[ ! -s out ] && [ ! -s err ] || fail "--quiet is not quiet"

expect 0 "$roomgraph" extract a.pgm -o o --verbose --timings
grep -q '162 x 82 cells' err || fail "--verbose does not tell the size"
grep -q voronoi_graph err || fail "--timings tells no steps"
if grep -q 'voronoi_graph\|cells' out; then fail "logs on stdout"; fi

cp a.pgm b.pgm
expect 0 "$roomgraph" compare a.pgm b.pgm --resolution 0.05 -o c --verbose --timings
grep -q '^roomgraph: b.pgm: cells of 0.05 m, .* 2 rooms, 0 scans$' err ||
  fail "--verbose of compare does not tell what the maps hold"
for step in read_maps compare write_files total; do
  grep -q "^  $step  *[0-9.]* ms$" err || fail "--timings of compare does not tell $step"
done
expect 0 "$roomgraph" compare a.pgm b.pgm --resolution 0.05 -o c --quiet
[ ! -s out ] && [ ! -s err ] || fail "--quiet of compare is not quiet"

expect 0 "$roomgraph" check a.pgm -o k --timings
for step in read_run check_run write_files total; do
  grep -q "^  $step  *[0-9.]* ms$" err || fail "--timings of check does not tell $step"
done

expect 0 "$roomgraph" extract a.pgm -o o --stages s
ls s/a/01_grid.png s/a/stages.json > /dev/null
