# An archive gives back what it knows: mended runs, one map of all, and places from run to run.
. "$(dirname "$0")/common.sh"

maps=$source_dir/share/roomgraph/maps
archive() { "$roomgraph" archive site.db "$@"; }

# A mended run lies beside the copy, whatever becomes of the file itself.
cp "$maps"/office_run[1234].simplemap.gz .
expect 2 archive add office_run1.simplemap.gz --repair
one_line err --keep
expect 0 archive add office_run[1234].simplemap.gz --keep kept --repair --cache cache
[ "$(wc -l < out)" -eq 8 ] || { cat out; fail "not two lines for each run"; }
mended=$(echo kept/*/office_run4.repaired.simplemap.gz)
[ -s "$mended" ] || { ls kept/*; cat out; fail "the last run is not mended"; }
grep -q "^$PWD/$mended: .*moved by up to" out || fail "not told"
expect 0 archive add office_run4.simplemap.gz --keep kept --repair
one_line out "is known already"
expect 0 archive list
[ "$(wc -l < out)" -eq 5 ] || fail "the mended ones count as runs"

# One map of the runs, with the names that the archive knows, and which it keeps.
expect 0 archive name R1 Kitchen
cp site.db before.db
expect 0 archive merge -o site --cache cache
[ -s site/site.simplemap.gz ] || fail "no map"
grep -q '"name":"Kitchen"' site/site.graph.json || fail "no name"
cmp <(sqlite3 site.db .dump) <(sqlite3 before.db .dump) || fail "the archive has changed"
expect 0 archive merge -o two --runs 2 --cache cache

# OLD and NEW by their names in the archive; the others tell how they bend.
printf 'name,x,y,yaw\ndock,0,0,0\n' > goals.csv
carry() { "$roomgraph" carry goals.csv --archive site.db -q --cache cache "$@"; }
expect 0 carry --from office_run1.simplemap.gz --to office_run2.simplemap.gz -o named
expect 0 "$roomgraph" carry goals.csv --from office_run1.simplemap.gz --to office_run2.simplemap.gz \
  --via office_run[34].simplemap.gz -o files -q --cache cache
cmp named/goals.csv files/goals.csv || fail "the archive carries otherwise"
sha=$(sha256sum office_run2.simplemap.gz | cut -c1-8)
expect 0 carry --from office_run1.simplemap.gz --to "$sha" --via office_run3.simplemap.gz -o hash
expect 1 carry --from office_run1.simplemap.gz --to office_run7.simplemap.gz -o none
one_line err site.db office_run7
cp kept/*/office_run1.simplemap.gz "$(echo kept/*/office_run2.simplemap.gz)"
expect 1 carry --from office_run1.simplemap.gz --to office_run2.simplemap.gz -o none
tail -n 1 err > last
one_line last office_run2 "another file now"
