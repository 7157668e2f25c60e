# `roomgraph score-rooms` compares two label pictures of one size.
. "$(dirname "$0")/common.sh"

# labels FILE SPLIT: a picture (PGM) of 40 x 30, split into two labels at that column.
labels() {
  { printf 'P2\n40 30\n65535\n'
    awk -v s="$2" 'BEGIN { for (i = 0; i < 1200; ++i) print (i % 40 < s ? 300 : 60000) }'
  } > "$1"
}
labels truth.pgm 20
labels half.pgm 10

expect 0 "$roomgraph" score-rooms truth.pgm truth.pgm
[ "$(grep -cE '^(P|R|IoU) .* 100\.00 %' out)" -eq 6 ] || { cat out; fail "not all is right"; }
grep -qE '^MCC +1\.0000' out || fail "the coefficient is not 1"
[ ! -s err ] || fail "something went to stderr"

# 300 of 300 and 600 of 900 pixels lie in one room; 300 of 600 and 600 of 600 are found.
expect 0 "$roomgraph" score-rooms half.pgm truth.pgm
grep -qE '^P micro +83\.33 %' out || fail "wrong P micro"
grep -qE '^P macro +75\.00 %' out || fail "wrong P macro"
grep -qE '^R micro +75\.00 %' out || fail "wrong R micro"
expect 0 "$roomgraph" score-rooms half.pgm truth.pgm --json
python3 - out <<'P'
import json, sys
score = json.load(open(sys.argv[1]))
assert score["labels"]["file"] == "half.pgm" and score["truth"]["regions"] == 2, score
assert score["p_micro_percent"] == 83.3333 and score["r_macro_percent"] == 75, score
P

plain empty.pgm 000
expect 0 "$roomgraph" score-rooms empty.pgm truth.pgm
grep -qE '^P micro +- %' out || fail "a mean of nothing"
grep -qE '^R micro +0\.00 %' out || fail "something was found in nothing"

rooms large.pgm
expect 1 "$roomgraph" score-rooms truth.pgm large.pgm
one_line err '40 x 30' '162 x 82'
[ ! -s out ] || fail "something went to stdout"
# A map is no picture of rooms, though its greys could be taken for labels.
{ printf 'P2\n40 30\n255\n'; for i in $(seq 600); do echo 254 205; done; } > map.pgm
expect 1 "$roomgraph" score-rooms truth.pgm map.pgm
one_line err map.pgm 'is a map'
# Nor is a plan of other greys, or in black and white; the same greys may be labels of two rooms.
for greys in '2 127 250' '0 255 255'; do
  { printf 'P2\n40 30\n255\n'; for i in $(seq 400); do echo "$greys"; done; } > plan.pgm
  { printf 'P2\n40 30\n255\n'; for i in $(seq 300); do echo 0 1 2 3; done; } > rooms.pgm
  expect 1 "$roomgraph" score-rooms plan.pgm rooms.pgm
  one_line err plan.pgm 'is a map'
  expect 1 "$roomgraph" score-rooms rooms.pgm plan.pgm
  one_line err plan.pgm 'is a map'
  expect 0 "$roomgraph" score-rooms plan.pgm plan.pgm
done
expect 1 "$roomgraph" score-rooms missing.png truth.pgm
one_line err missing.png
echo 'no picture' > junk.png
expect 1 "$roomgraph" score-rooms truth.pgm junk.png
one_line err junk.png png
expect 2 "$roomgraph" score-rooms truth.pgm
one_line err TRUTH
expect 2 "$roomgraph" score-rooms truth.pgm truth.pgm truth.pgm
expect 2 "$roomgraph" score-rooms truth.pgm truth.pgm --no-such-option
one_line err --no-such-option
expect 0 "$roomgraph" score-rooms --help
