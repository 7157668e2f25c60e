# `roomgraph repair` mends runs by what all tell together, and one alone by what it saw twice.
. "$(dirname "$0")/common.sh"

maps=$source_dir/share/roomgraph/maps

# error RUN...: map error of the last run among the others.
error() {
  expect 0 "$roomgraph" compare -q "$@" -o compared
  python3 - "$(basename "${*: -1}" | sed 's/\.simplemap.*//')" <<'P'
import json, sys
runs = json.load(open("compared/comparison.json"))["runs"]
print(next(run["map_error_m"] for run in runs if run["name"] == sys.argv[1]))
P
}
# less A B: a number is less than another.
less() { python3 -c "import sys; sys.exit(not $1 < $2)" || fail "$1 is not less than $2"; }

expect 0 "$roomgraph" repair "$maps"/office_run3.simplemap.gz -o alone
grep -q '^office_run3: mended.*driven once' out || fail "does not say what became of it"
[ "$(grep '^  ' out | sort)" = "$(ls -d alone/* | sed 's/^/  /' | LC_ALL=C sort)" ] || { cat out; fail "not each file"; }
for file in simplemap.gz tum gridmap.gz yaml pgm; do
  [ -s alone/office_run3.repaired.$file ] || fail "no $file"
done
[ ! -e alone/site.g2o ] || fail "one run is no site"
others=("$maps"/office_run1.simplemap.gz "$maps"/office_run4.simplemap.gz)
less "$(error "${others[@]}" alone/office_run3.repaired.simplemap.gz)" \
  "0.5 * $(error "${others[@]}" "$maps"/office_run3.simplemap.gz)"

expect 0 "$roomgraph" repair "$maps"/office_run[134].simplemap.gz -o together
[ "$(grep -c '^office_run' out)" -eq 3 ] || fail "not a line for each run"
[ -s together/site.g2o ] || fail "no pose graph of the site"
[ "$(grep -c '<section>' together/repair.html)" -eq 3 ] || fail "not a picture of each run"
less "$(error "${others[@]}" together/office_run3.repaired.simplemap.gz)" \
  "0.5 * $(error "${others[@]}" "$maps"/office_run3.simplemap.gz)"

# A sound run keeps its bytes, but for how they are packed.
expect 0 "$roomgraph" repair "$maps"/office_run1.simplemap.gz -o sound --format mola
grep -q '^office_run1: left as it was' out || fail "a sound run is mended"
cmp <(zcat sound/office_run1.repaired.simplemap.gz) <(zcat "$maps"/office_run1.simplemap.gz) ||
  fail "a sound run was changed"
[ -s sound/office_run1.loop_constraints.yaml ] || fail "no constraints"

# Grids and simplemaps are of one call: where the former do not fit on the disk, and where nothing is mended any more.
cp -r alone again
code=0
(trap '' XFSZ; ulimit -f 200
  "$roomgraph" repair "$maps"/office_run[134].simplemap.gz --only office_run3 -q -o again) 2> err || code=$?
[ $code -eq 1 ] || fail "the grid fitted on the disk"
diff -r alone again || fail "half of the results were replaced"
cp "$maps"/office_run1.simplemap.gz office_run3.simplemap.gz
expect 0 "$roomgraph" repair office_run3.simplemap.gz -o again
grep -q '^office_run3: left as it was' out || fail "a sound run is mended"
expect 0 "$roomgraph" convert again/office_run3.repaired.simplemap.gz --format ros -o converted
cmp converted/office_run3.repaired.pgm again/office_run3.repaired.pgm || fail "an older grid is still there"

expect 1 "$roomgraph" repair "$maps"/office.gridmap.gz -o grid
one_line err office.gridmap.gz "no scans" simplemap
expect 2 "$roomgraph" repair "$maps"/office_run1.simplemap.gz --only another -o grid
one_line err another

# A run that does not lie in the site of the others is not mended, which is no success; nor does it matter where another
# run was asked for.
cp "$maps"/office_run1.simplemap.gz run1.simplemap.gz
rooms other.pgm
apart=(run1.simplemap.gz "$maps"/office_run2.simplemap.gz other.pgm --resolution 0.2 -o apart)
expect 1 "$roomgraph" repair "${apart[@]}"
one_line err "other.pgm: does not lie in the site of the others: left out"
expect 0 "$roomgraph" repair "${apart[@]}" --only run1
[ -s apart/run1.repaired.simplemap.gz ] || fail "the others were not written"
# Of two runs that have nothing in common none is mended, as if others had told of it.
expect 1 "$roomgraph" repair run1.simplemap.gz other.pgm --resolution 0.2 -o lone
grep -q "no two runs lie in one site" err || fail "mended by nobody"
[ -z "$(ls lone)" ] || fail "wrote of a site of one run"
