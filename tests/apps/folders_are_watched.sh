# roomgraph watch: maps that are written into a folder are judged and archived once they are whole.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps
watcher=
trap '[ -z "$watcher" ] || kill -KILL "$watcher" 2> /dev/null; rm -rf "$work"' EXIT
mkdir in

# start: the watch, whose lines go to the file lines.
start() {
  "$roomgraph" watch in --archive site.db --robot anna --exec 'cat >> told; echo called' >> lines 2>> errors &
  watcher=$!
}
# has_lines COUNT: waits up to 30 s for so many lines; the machine may be busy.
has_lines() {
  local i
  for i in $(seq 300); do [ "$(wc -l < lines)" -lt "$1" ] || break; sleep 0.1; done
  [ "$(wc -l < lines)" -eq "$1" ] || { cat lines errors >&2; fail "not $1 lines"; }
}
# begins MAP FILE, ends MAP: writes a map to a file that stays open in between.
begins() {
  exec 3> "$2"
  head -c 9000 "$maps/$1" >&3
}
ends() {
  tail -c +9001 "$maps/$1" >&3
  exec 3>&-
}
field() { tail -1 lines | python3 -c "import json, sys; print(json.load(sys.stdin)['$1'])"; }

: > lines
cp "$maps/office_run1.simplemap.gz" in/one.simplemap.gz
cp "$maps/README.md" in/README.md
start
has_lines 1
[ "$(field file)" = in/one.simplemap.gz ] && [ "$(field error)" = None ] || fail "what was there is not added"

# A file that is still being written is no map, however long it takes; then it is one, once.
begins office_run2.simplemap.gz in/two.simplemap.gz
sleep 3.5
[ "$(wc -l < lines)" -eq 1 ] || fail "half a map is judged"
ends office_run2.simplemap.gz
has_lines 2
[ "$(field file)" = in/two.simplemap.gz ] && [ "$(field error)" = None ] || fail "not judged when whole"
# So is one that is moved into the folder; the third run of a site is judged.
cp "$maps/office_run4.simplemap.gz" three.part
mv three.part in/three.simplemap.gz
has_lines 3
[ "$(field meaningful)" = True ] && [ "$(field placed)" = True ] || fail "the third is not judged"
# A ROS map whose picture comes after its yaml is not read before.
printf 'image: plan.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n' > in/plan.yaml
sleep 1
rooms in/plan.pgm
has_lines 4
[ "$(field file)" = in/plan.yaml ] && [ "$(field error)" = None ] || fail "the ROS map is not added"
# What is no map is told, and stops nothing.
head -c 500 "$maps/office.gridmap.gz" > in/bad.gridmap.gz
has_lines 5
field error | grep -q bad.gridmap.gz || fail "no error for a damaged map"
# A link is a map, too.
cp "$maps/office_run3.simplemap.gz" linked
ln -s ../linked in/link.SIMPLEMAP.gz
has_lines 6
[ "$(field file)" = in/link.SIMPLEMAP.gz ] && [ "$(field error)" = None ] || fail "a link is not added"
# The command has had each line, and its output is no line.
for i in $(seq 50); do cmp -s told lines && break; sleep 0.1; done
cmp -s told lines || fail "the command has had other lines"
[ "$(grep -c called errors)" = 6 ] || fail "the command's output is lost"
# A ROS map is read again once its picture is there, also where that has another name.
sed s/plan.pgm/drawing.pgm/ in/plan.yaml > in/other.yaml
has_lines 7
field error | grep -q drawing.pgm || fail "no error for a map without its picture"
rooms in/drawing.pgm 200
has_lines 8
[ "$(field file)" = in/other.yaml ] && [ "$(field error)" = None ] || fail "not read with its picture"

# A kill loses nothing: what the archive knows is not told again, what came meanwhile is.
kill -KILL $watcher
wait $watcher 2> /dev/null || true
rm in/bad.gridmap.gz
cp "$maps/office.gridmap.gz" in/four.gridmap.gz
begins office.simplemap.gz in/five.simplemap.gz
touch -d '1 hour ago' in/*
: > lines
start 3>&-
has_lines 1
[ "$(field file)" = in/four.gridmap.gz ] || fail "not only what is new"
# Nor is half a map that somebody is writing at the start.
sleep 1
[ "$(wc -l < lines)" -eq 1 ] || fail "half a map is judged at the start"
ends office.simplemap.gz
has_lines 2
[ "$(field file)" = in/five.simplemap.gz ] && [ "$(field error)" = None ] || fail "not judged when whole"
expect 0 "$roomgraph" archive site.db list
[ "$(grep -c anna out)" = 8 ] || { cat out >&2; fail "not eight runs in the archive"; }

# It ends by the signal that it gets, and with its folder.
kill -TERM $watcher
code=0
wait $watcher || code=$?
watcher=
[ $code -eq 143 ] || fail "ends with $code, not by SIGTERM"
# With its archive, too, so that no map is passed over.
cp site.db kept.db
: > lines
start
sleep 1
printf 'this is no archive' > site.db
cp "$maps/office_run3.simplemap.gz" in/six.simplemap.gz
code=0
wait $watcher || code=$?
watcher=
[ $code -eq 1 ] || fail "ends with $code where its archive is broken"
[ ! -s lines ] || fail "blames the map for the archive"
tail -1 errors | grep -q 'site.db: ' || fail "does not name the archive"
cp kept.db site.db && rm -f site.db-wal site.db-shm in/six.simplemap.gz
: > lines
start
sleep 1
rm -r in
code=0
wait $watcher || code=$?
watcher=
[ $code -eq 1 ] || fail "ends with $code where its folder is gone"
tail -1 errors | grep -q 'in: is gone' || fail "does not say that its folder is gone"
expect 1 "$roomgraph" watch in --archive site.db
one_line err "in: cannot be watched"
expect 2 "$roomgraph" watch .
