# Two maps whose results would have the same name: nothing is computed, both are named.
. "$(dirname "$0")/common.sh"
mkdir one two
rooms one/office.pgm
cp one/office.pgm two/office.gridmap.gz
expect 2 "$roomgraph" extract one/office.pgm two/office.gridmap.gz -o o
one_line err one/office.pgm two/office.gridmap.gz
[ ! -e o ] || fail "a folder was made"
expect 2 "$roomgraph" extract one/office.pgm one/office.pgm -o o

# Only extensions of maps are taken off.
cp one/office.pgm odd.name.gridmap
cp one/office.pgm scan.dat
expect 0 "$roomgraph" extract one/office.pgm odd.name.gridmap scan.dat -o o --format json
[ "$(cd o && echo *)" = "odd.name.json office.json scan.dat.json" ] || fail "names: $(ls o)"
