# Where a place is, and how to get from one to another: of a map, and of the graph made from it.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm --resolution 0.05 --format json -o g -q
for map in g/a.json "a.pgm --resolution 0.05"; do
  expect 0 "$roomgraph" where $map 1 1
  grep -q '^R0: a room' out || fail "not in the left room: $map"
  grep -q 'm wide, to ' out || fail "does not say where its door leads: $map"
  expect 0 "$roomgraph" route $map --from R0 --to 6 1
  grep -qE '^[0-9.]+ m, at least [01]\.[0-9]+ m wide except for [0-9.]+ m in a straight line' out ||
    fail "no width"
  [ "$(sed -n 2p out)" = "  R0" ] || fail "does not start in R0: $map"
  tail -n 1 out | grep -q 'to R1$' || fail "does not end in R1: $map"
done
# A robot that is too wide for the door gets no way through it.
expect 0 "$roomgraph" route g/a.json --from R0 --to R1 --robot-width 0.3
expect 1 "$roomgraph" route g/a.json --from R0 --to R1 --robot-width 3
grep -q 'no way along the graph that is 3.00 m wide' out || fail "does not say that it is too wide"
# A place that is in no free space is told, however far the nearest way is.
expect 1 "$roomgraph" where g/a.json -5 -5
one_line err g/a.json "(-5.00, -5.00)" "in no room and no corridor" "nearest way is" "free space"
[ ! -s out ] || fail "it tells of a place outside"
for places in "--from -100 -100 --to R1" "--from R0 --to 400 -1"; do
  # shellcheck disable=SC2086
  expect 1 "$roomgraph" route g/a.json $places
  one_line err "in no room and no corridor"
  [ ! -s out ] || fail "a way that leads to nowhere"
done
# In one room with a pillar the ways lead round it, and no place is in it; an empty one has none.
python3 - <<'P'
cells = [[254] * 100 for _ in range(100)]
for i in range(100):
    for row, column in ((i, 0), (i, 99), (0, i), (99, i)):
        cells[row][column] = 0
open("empty.pgm", "wb").write(b"P5\n100 100\n255\n" + bytes(sum(cells, [])))
for row in range(48, 54):
    cells[row][48:54] = [0] * 6
open("pillar.pgm", "wb").write(b"P5\n100 100\n255\n" + bytes(sum(cells, [])))
P
expect 0 "$roomgraph" route pillar.pgm --resolution 0.05 --from 1 1 --to 4 4
expect 1 "$roomgraph" route empty.pgm --resolution 0.05 --from 1 1 --to 4 4
grep -q 'R0, which has no ways' out || fail "does not say that a room has no ways"
expect 1 "$roomgraph" where pillar.pgm --resolution 0.05 2.45 2.45
one_line err pillar.pgm "(2.45, 2.45)" "in an obstacle" "free space"
# Rooms have the names that they were given, and no number beside.
python3 - <<'P'
import json
graph = json.load(open("g/a.json"))
for number, area in enumerate(graph["areas"]):
    area["name"] = f"R{number}" if number else "Kitchen"
open("g/named.json", "w").write(json.dumps(graph))
P
kitchen=$(python3 -c 'import json; print(*json.load(open("g/named.json"))["areas"][0]["widest_place"])')
# shellcheck disable=SC2086
expect 0 "$roomgraph" where g/named.json $kitchen
grep -q '^Kitchen: a room' out || fail "not by its name"
expect 0 "$roomgraph" route g/named.json --from Kitchen --to R1
[ "$(sed -n 2p out)" = "  Kitchen" ] && tail -n 1 out | grep -q 'to R1$' || fail "not by their names"
expect 2 "$roomgraph" route g/named.json --from Kitchen --to R0
one_line err "--to" "Kitchen" "R1"
expect 2 "$roomgraph" route g/a.json --from R7 --to R0
one_line err "--from" "R0 to R1"
expect 1 "$roomgraph" where none.json 1 1
one_line err none.json
expect 2 "$roomgraph" where g/a.json nan 1
one_line err "metres"
expect 2 "$roomgraph" where g/a.json left 1
one_line err "X: 'left' is not a number"
expect 2 "$roomgraph" route g/a.json --from inf 0 --to R0
one_line err "--from 1.5 2"
# A corridor is on its ways, though a pillar stands where it is widest, in a crossing.
python3 - <<'P'
side = 300
cells = [[0] * side for _ in range(side)]
def free(x, y, width, height):
    for row in range(y, y + height):
        cells[row][x:x + width] = [254] * width
for x, y in ((20, 20), (180, 20), (20, 180), (180, 180)):
    free(x, y, 100, 100)
free(20, 130, 260, 40)
free(130, 20, 40, 260)
for x in (50, 220):
    free(x, 120, 18, 10)
    free(x, 170, 18, 10)
for row in range(145, 155):
    cells[row][145:155] = [0] * 10
open("crossing.pgm", "wb").write(b"P5\n300 300\n255\n" + bytes(sum(cells, [])))
P
expect 0 "$roomgraph" extract crossing.pgm --resolution 0.05 --format json -o g -q
corridor=$(python3 -c "import json
areas = json.load(open('g/crossing.json'))['areas']
print('C%d' % max((a['area'], a['id']) for a in areas if a['kind'] == 'corridor')[1])")
for map in g/crossing.json "crossing.pgm --resolution 0.05"; do
  # shellcheck disable=SC2086
  expect 0 "$roomgraph" route $map --from "$corridor" --to R0
done
