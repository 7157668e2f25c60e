# `roomgraph archive` keeps each run once, whatever happens, and says what it knows.
. "$(dirname "$0")/common.sh"

# night N: the map of two rooms as a drive of night N has drawn it.
night() {
  rooms room.pgm 162 "$1"
  { printf 'P5\n# night %d\n' "$1"; tail -n +2 room.pgm; } > "night$1.pgm"
}
for n in $(seq 12); do night "$n"; done
add() { "$roomgraph" archive "$@" --resolution 0.05 -q; }
count() { sqlite3 "$1" "SELECT count(*) FROM run"; }
whole() {
  [ "$(sqlite3 "$1" 'PRAGMA integrity_check; PRAGMA foreign_key_check')" = ok ] ||
    fail "$1 is damaged"
  # Each run that could be judged has its figures and rooms, and nobody else has any.
  [ "$(sqlite3 "$1" "SELECT count(*) FROM run WHERE state = 'placed' AND id NOT IN
    (SELECT run FROM figure)")" = 0 ] || fail "a run of $1 without figures"
}

expect 0 add site.db add night1.pgm night2.pgm night3.pgm --robot anna --time 2026-11-01
[ "$(count site.db)" = 3 ] || fail "not three runs"
whole site.db
[ "$(sqlite3 site.db "SELECT count(*) FROM figure WHERE name = 'map_error_m' AND meaningful")" = 3 ] ||
  fail "three runs of one site are not judged"
[ "$(sqlite3 site.db 'SELECT group_concat(id) FROM room')" = R1,R2 ] || fail "other rooms"
[ -z "$(sqlite3 site.db "SELECT 1 FROM settings WHERE options NOT LIKE '%load_grid.resolution=0.05%'")" ] ||
  fail "no options"

# What others do not judge yet is told by itself.
maps=$source_dir/share/roomgraph/maps
expect 0 "$roomgraph" archive alone.db add "$maps/office_run1.simplemap.gz"
grep -q 'no other run to compare it with; by itself: ' out || fail "the first run is not told by itself"
expect 0 "$roomgraph" archive alone.db export --format json
grep -q '"self_error"' out && grep -q '"self_breaks"' out || fail "no figures of the first run"
expect 0 "$roomgraph" archive alone.db add "$maps"/office_run[234].simplemap.gz
[ "$(sqlite3 alone.db "SELECT count(*) FROM figure WHERE name = 'self_error' AND run IN
  (SELECT run FROM figure WHERE name = 'map_error_m' AND meaningful)")" = 0 ] ||
  fail "what others judge is still told by itself"

# What is known is not added again, under whatever name.
cp site.db before.db
cp night1.pgm again.pgm
expect 0 "$roomgraph" archive site.db add again.pgm night2.pgm --resolution 0.05 --robot berta
grep -qx 'again.pgm: is known already' out || fail "not said to be known"
cmp <(sqlite3 site.db .dump) <(sqlite3 before.db .dump)

# A map that cannot be read is a line; the others are added.
head -c 1000 night5.pgm > damaged.pgm
expect 1 add site.db add damaged.pgm night4.pgm
one_line err damaged.pgm
[ "$(count site.db)" = 4 ] || fail "the good one was not added"
expect 1 add other.db add damaged.pgm
one_line err damaged.pgm
expect 2 add site.db add night5.pgm --time yesterday
one_line err yesterday
expect 1 "$roomgraph" archive none.db report
one_line err none.db "no such archive"
expect 1 "$roomgraph" archive night1.pgm report
one_line err night1.pgm
expect 2 "$roomgraph" archive site.db report --site lab
one_line err lab

# Files that are gone, or others now, are not compared with, and that is said.
mv night1.pgm gone.pgm
cp night9.pgm night2.pgm
expect 0 add site.db add night5.pgm
one_line err night1.pgm "(and 1 more): note: is missing or has changed"
[ "$(sqlite3 site.db 'SELECT count(*) FROM compared WHERE comparison = (SELECT max(id) FROM comparison)')" = 3 ] ||
  fail "compared with others than those that are there"
mv gone.pgm night1.pgm
night 2

# A file that the next night takes the place of is kept as a copy, and compared with.
for n in 6 7 8; do
  cp "night$n.pgm" latest.pgm
  expect 0 add kept.db add latest.pgm --keep kept --time "2026-11-0$n"
  [ ! -s err ] || { cat err; fail "something is missing"; }
done
rm latest.pgm
[ "$(sqlite3 kept.db "SELECT count(*) FROM figure WHERE name = 'map_error_m' AND meaningful")" = 3 ] ||
  fail "not compared with the copies"
[ "$(find kept -name latest.pgm | wc -l)" = 3 ] || fail "not three copies"

# Another building is kept as that, and not compared with.
{ printf 'P5\n300 200\n255\n'
  awk 'BEGIN { for (y = 0; y < 200; ++y) for (x = 0; x < 300; ++x) {
    wall = x < 3 || y < 3 || x >= 297 || y >= 197 || (x - 120) ^ 2 + (y - 90) ^ 2 < 900
    printf "%s", wall ? "#" : "~" } }' |
    tr '#~' '\000\377'; } > hall.pgm
expect 0 "$roomgraph" archive site.db add hall.pgm --resolution 0.05
grep -q 'another site' out || fail "the hall is not told apart"
whole site.db

# A time that is still to come would be the latest for years.
expect 2 "$roomgraph" archive site.db add --time 9999-12-31 "$maps/office_run1.simplemap.gz"
one_line err "is still to come"
whole site.db

# Lists, reports and exports.
printf 'site,file\nlab,none.pgm\n' > none.csv
expect 1 "$roomgraph" plan none.csv --archive empty.db -o plan
expect 0 "$roomgraph" archive empty.db report
one_line err "empty.db: note: has no runs yet"
expect 0 "$roomgraph" archive site.db list
[ "$(wc -l < out)" = 7 ] || fail "not a line per run"
expect 0 "$roomgraph" archive site.db rooms
grep -qx '  R1' out || { cat out; fail "no room"; }
expect 0 "$roomgraph" archive site.db name R1 "Kitchen, small"
expect 0 "$roomgraph" archive site.db rooms
grep -qx '  R1  Kitchen, small' out || { cat out; fail "no name"; }
expect 1 "$roomgraph" archive site.db name R77 Attic
one_line err R77
expect 0 "$roomgraph" archive site.db report
grep -q '^  anna: yes, the map of 2026-11-01 may be rolled out; ' out || { cat out; fail "no line on anna"; }
grep -q '^  robot: no, the map of .* fits no other map of the site' out || { cat out; fail "the hall may go out"; }
expect 3 "$roomgraph" archive site.db report --fail-on-latest -q
one_line err 'site: robot: no, the map of'
expect 0 "$roomgraph" archive site.db report --fail-on-alarm -q -o page.html
[ ! -s out ] || fail "-q prints"
grep -q "<h1>1 robot of 2 needs attention</h1>" page.html || { grep "<h1>" page.html; fail "no page"; }
expect 0 "$roomgraph" archive site.db export -o runs.csv
[ "$(wc -l < runs.csv)" = 7 ] || fail "not a line per run in the csv"
expect 0 "$roomgraph" archive site.db export --format json -o archive.json
python3 -c 'import json; assert len(json.load(open("archive.json"))["sites"][0]["runs"]) == 6'
expect 0 "$roomgraph" archive site.db export --format prometheus
grep -q '^roomgraph_map_error_metres{site="site",robot="anna"} ' out || fail "no gauge"

# Maps that got worse are an alarm: here by hand, as if five nights had been bad.
cp site.db bad.db
sqlite3 bad.db "UPDATE figure SET value = 2 WHERE name = 'map_error_m';
  UPDATE run SET robot = 'anna'"
expect 0 "$roomgraph" archive bad.db report
grep -q '^  anna: no, .*; its latest maps are above the limit of 0.30 m; no good one is known$' out || { cat out; fail "no alarm"; }
expect 3 "$roomgraph" archive bad.db report --fail-on-alarm -q
one_line err 'anna: its latest maps are above the limit'
expect 0 "$roomgraph" archive bad.db report --fail-on-alarm --limit 3
expect 2 "$roomgraph" archive bad.db report --fail-on-alarm --limit nan
# So is an archive that has lost its runs.
cp site.db none.db
sqlite3 none.db "DELETE FROM run"
for asked in --fail-on-alarm --fail-on-latest; do
  expect 3 "$roomgraph" archive none.db report $asked -q
  one_line err 'site: has no runs'
done
sqlite3 none.db "DELETE FROM site"
expect 3 "$roomgraph" archive none.db report --fail-on-alarm -q
one_line err 'none.db: has no runs'

# A run that should not be there is taken out, and a robot gets another name.
cp site.db less.db
expect 1 "$roomgraph" archive less.db remove none.pgm
one_line err none.pgm
expect 0 "$roomgraph" archive less.db remove hall.pgm
[ "$(count less.db)" = 5 ] || fail "the hall is still there"
expect 0 "$roomgraph" archive less.db rename robot anna
expect 0 "$roomgraph" archive less.db report --fail-on-latest -q
expect 1 "$roomgraph" archive less.db rename robot anna
one_line err robot
whole less.db

# The archive is not replaced by what is told of it.
cp site.db before.db
for call in report export; do
  expect 2 "$roomgraph" archive site.db $call -o ./site.db
  one_line err "would replace a file that is read"
done
cmp site.db before.db

# Two at once lose nothing and double nothing.
two=(night{1..6}.pgm)
(add both.db add "${two[@]}" --robot one) & first=$!
(add both.db add night{6,5,4,3,2,1}.pgm --robot two) & second=$!
wait $first && wait $second || fail "one of two at once has failed"
[ "$(count both.db)" = 6 ] || fail "$(count both.db) runs of two at once, not 6"
whole both.db

# Killed again and again, at ever later moments, then let go: the same runs as without.
for tenths in 1 2 3 4 5 6 7 8 9 10 12 14 16; do
  timeout -s KILL "$(awk "BEGIN { print $tenths / 10 }")" \
    "$roomgraph" archive killed.db add night{1..6}.pgm --resolution 0.05 -q 2> /dev/null || true
  [ ! -e killed.db ] || [ -z "$(sqlite3 killed.db .tables)" ] || whole killed.db
done
expect 0 add killed.db add night{1..6}.pgm
[ "$(count killed.db)" = 6 ] || fail "not 6 runs after being killed"
expect 0 add calm.db add night{1..6}.pgm
for table in "run ORDER BY sha256" "figure" "sighting"; do
  columns='*'
  [ "$table" != "run ORDER BY sha256" ] || columns='sha256, state, reason'
  cmp <(sqlite3 killed.db "SELECT $columns FROM $table") \
    <(sqlite3 calm.db "SELECT $columns FROM $table")
done

# A mistyped name leaves no archive behind, and a name is not a page long.
expect 1 "$roomgraph" archive typo.db add nigth1.pgm
one_line err nigth1.pgm "no such file"
printf 'P5 9 9 255\n' > damaged.pgm
expect 1 "$roomgraph" archive typo.db add nigth1.pgm damaged.pgm
[ "$(wc -l < err)" -eq 2 ] || fail "not a line for each file"
[ ! -e typo.db ] || fail "an archive without any run"
expect 2 "$roomgraph" archive site.db add night1.pgm --robot "$(printf 'x%.0s' {1..300})"
one_line err --robot "at most 200"
