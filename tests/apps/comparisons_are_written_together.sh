# The results of a comparison are all of it, or all of an earlier one, whatever goes wrong.
. "$(dirname "$0")/common.sh"
map=$source_dir/share/roomgraph/maps/office.gridmap.gz
cp "$map" a.gridmap.gz
cp "$map" b.gridmap.gz
cp "$map" c.gridmap.gz
expect 0 "$roomgraph" compare a.gridmap.gz b.gridmap.gz -o o --names o/site.json
cp -r o before

# No map can be read: nothing to write.
echo junk > junk.gridmap
plain grey.pgm 315
expect 1 "$roomgraph" compare junk.gridmap missing.gridmap grey.pgm --resolution 0.05 -o o --names o/site.json
[ "$(wc -l < err)" -eq 4 ] || { cat err; fail "not a line for each map and one more"; }
grep -q '^roomgraph: no map could be used' err || fail "nothing said of the results"
[ ! -s out ] || fail "told of results"
diff -r o before
# The others are compared: theirs take the place of earlier results.
cp -r o rest
expect 1 "$roomgraph" compare a.gridmap.gz junk.gridmap c.gridmap.gz -o rest
one_line err junk.gridmap
grep -q '"name":"c"' rest/comparison.json || fail "the earlier results are still there"
# One is enough.
expect 1 "$roomgraph" compare junk.gridmap c.gridmap.gz -o one
grep -q '"name":"c"' one/comparison.json || fail "no results of one map"
grep -q "nothing was compared: only one map could be used" err || fail "another reason"

# No room for the report, the last and largest file.
sed -i 's/"name":"R3"/"name":"Kitchen"/' o/site.json before/site.json
( trap '' XFSZ   # the program is told that the file is too large, not stopped
  ulimit -f 200
  expect 1 "$roomgraph" compare a.gridmap.gz c.gridmap.gz -o o --names o/site.json )
one_line err report.html
diff -r o before

# A place that cannot be taken.
rm o/report.html before/report.html
mkdir o/report.html before/report.html
expect 1 "$roomgraph" compare a.gridmap.gz c.gridmap.gz -o o --names o/site.json
one_line err report.html
diff -r o before

rmdir o/report.html
expect 0 "$roomgraph" compare a.gridmap.gz c.gridmap.gz -o o --names o/site.json
[ "$(ls -A o | wc -l)" -eq 8 ] || fail "not seven results and the names"
