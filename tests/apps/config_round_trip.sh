# The options that are written into a result give the same result again.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o one --format json --room-width 2.5 --resolution 0.04 \
  --set dead_ends.min_reach=0.45 --set keep_components.only_largest=true
expect 0 "$roomgraph" extract a.pgm -o two --format json --config one/a.json
cmp one/a.json two/a.json
expect 0 "$roomgraph" extract a.pgm -o three --format json
if cmp -s one/a.json three/a.json; then fail "the options change nothing"; fi

# The same by way of an ini file.
"$roomgraph" config --config one/a.json > a.ini
expect 0 "$roomgraph" extract a.pgm -o four --format json --config a.ini
cmp one/a.json four/a.json

# Shorthands win over the file.
expect 0 "$roomgraph" extract a.pgm -o five --format json --config a.ini --resolution 0.05
grep -q '"load_grid": {"resolution":0.05,' five/a.json || fail "--resolution does not win over --config"

printf '[find_rooms]\nmin_width = 900\n' > bad.ini
expect 2 "$roomgraph" extract a.pgm --config bad.ini
one_line err bad.ini:2 min_width 900

# A file of no bytes has lost its options: it does not pass for one without any.
: > empty.ini
expect 2 "$roomgraph" extract a.pgm --config empty.ini
one_line err empty.ini "is empty" "roomgraph config"
