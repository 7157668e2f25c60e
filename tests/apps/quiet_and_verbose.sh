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

expect 0 "$roomgraph" extract a.pgm -o o --stages s
ls s/a/01_grid.png s/a/stages.json > /dev/null
