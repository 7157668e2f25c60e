# One map that cannot be read: one line, exit code 1, and the others are done all the same.
. "$(dirname "$0")/common.sh"
rooms a.pgm
head -c 3000 a.pgm > cut.pgm
echo 'no map' > text.gridmap
rooms b.pgm
expect 1 "$roomgraph" extract a.pgm cut.pgm text.gridmap b.pgm -o o --format json --quiet
[ "$(wc -l < err)" -eq 2 ] || fail "not one line per bad map: $(cat err)"
sed -n 1p err | grep -q cut.pgm || fail "cut.pgm is not told first"
sed -n 2p err | grep -q text.gridmap || fail "text.gridmap is not told second"
[ "$(cd o && echo *)" = "a.json b.json" ] || fail "results: $(ls o)"
