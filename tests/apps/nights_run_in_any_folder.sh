# share/roomgraph/parallel/night: a folder's name is a name and nothing else, and lists as spreadsheets leave them.
. "$(dirname "$0")/common.sh"
command -v parallel > /dev/null || { echo "skipped: there is no GNU parallel"; exit 77; }
mkdir bin maps
ln -s "$roomgraph" bin/roomgraph
PATH=$PWD/bin:$PATH
night=$source_dir/share/roomgraph/parallel/night
rooms maps/a.pgm
rooms maps/b.pgm 164
printf '\xef\xbb\xbfsite,file,time\r\noffice,maps/a.pgm,2026-11-01\r\noffice,maps/b.pgm,2026-11-02\r\n' > list.csv

expect 2 "$night" list.csv
one_line err "night: give LIST ARCHIVE FOLDER"

for folder in 'my night' 'n$(touch pwned)' 'n;touch pwned;x' "it's"; do
  rm -f a.db
  expect 0 "$night" list.csv a.db "$folder" --resolution 0.05
  [ "$(sqlite3 a.db 'SELECT count(*) FROM run')" = 2 ] || { cat err; fail "nothing is done in '$folder'"; }
  [ -s "$folder/fleet.html" ] || fail "no page in '$folder'"
done
cp list.csv -- -list.csv
expect 0 "$night" -list.csv -a.db -folder --resolution 0.05
[ -s ./-a.db ] && [ -s ./-folder/fleet.html ] || fail "names with a dash are lost"
expect 2 "$night" list.csv a.db options --no-such-option
one_line err no-such-option
# One night at a time in a folder.
(flock 9; sleep 5) 9> -folder/lock &
sleep 0.5
expect 1 "$night" list.csv a.db -folder --resolution 0.05
one_line err "another night is at work in ./-folder"
wait
[ ! -e pwned ] || fail "the name of a folder was executed"

# A line that is wrong costs itself alone, and is told; a list without any run is an export that has failed.
rm a.db
printf 'site,file,time\noffice,maps/a.pgm,tonight\noffice,maps/b.pgm,2026-11-02\n' > bad.csv
expect 1 "$night" bad.csv a.db bad --resolution 0.05
grep -q "bad.csv: line 2: 'tonight' is not a time" err || { cat err; fail "the bad line is not told"; }
[ "$(grep -c "not a time" err)" = 1 ] || { cat err; fail "the bad line is told twice"; }
[ "$(sqlite3 a.db 'SELECT count(*) FROM run')" = 1 ] || fail "the good line is not done"
# So is a map that is damaged.
head -c 300 "$source_dir/share/roomgraph/maps/office.gridmap.gz" | gunzip 2> /dev/null > maps/cut.gridmap || true
printf 'site,file\noffice,maps/a.pgm\noffice,maps/cut.gridmap\n' > cut.csv
expect 1 "$night" cut.csv a.db cut --resolution 0.05
[ "$(grep -c cut.gridmap err)" = 1 ] || { cat err; fail "the damaged map is not told once"; }
echo site,file > empty.csv
expect 1 "$night" empty.csv a.db empty
grep -q 'empty.csv: lists no run' err || { cat err; fail "an empty list is not told"; }
