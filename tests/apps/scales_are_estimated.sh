# `roomgraph compare --estimate-scale` reads bare pictures at the scale at which they fit the others.
. "$(dirname "$0")/common.sh"

# building FILE CELLS_PER_METRE [SHIFT]: a picture (PGM) of five rooms and a corridor, 12 m by 9 m;
# the walls inside lie SHIFT metres further to the right.
building() {
  local cells=$2 width=$((12 * $2 + 8)) height=$((9 * $2 + 8))
  { printf 'P5\n%d %d\n255\n' "$width" "$height"
    awk -v w="$width" -v h="$height" -v n="$cells" -v s="${3-0}" '
    function near(a, b) { return a > b - 0.1 && a < b + 0.1 }
    function within(a, low, high) { return a > low && a < high }
    BEGIN {
      for (row = h - 1; row >= 0; --row) for (column = 0; column < w; ++column) {
        x = (column - 3.5) / n; y = (row - 3.5) / n
        outer = x < 0.1 || y < 0.1 || x > 11.9 || y > 8.9
        along = near(y, 4) && !within(x - s, 1, 2) && !within(x - s, 8.6, 9.5) ||
                near(y, 5.6) && !within(x - s, 3, 3.9) && !within(x - s, 10, 11)
        across = y < 4 && (near(x - s, 3.1) || near(x - s, 7)) || y > 5.6 && near(x - s, 5.2)
        # Both lower walls have a door, so that no room is closed.
        door = within(y, 1.2, 2.1)
        printf "%s", outer || along || across && !(y < 4 && door) ? "#" : "~"
      } }' | tr '#~' '\000\377'
  } > "$1"
}

# yaml FILE PICTURE: the picture as a ROS map of 0.05 m.
yaml() {
  printf 'image: %s\nresolution: 0.05\norigin: [1, -2, 0]\nnegate: 0\n' "$2" > "$1"
  printf 'occupied_thresh: 0.65\nfree_thresh: 0.196\n' >> "$1"
}

mkdir pictures
building pictures/one.pgm 20
building pictures/two.pgm 20 0.05
building plan.pgm 33
yaml one.yaml pictures/one.pgm
yaml two.yaml pictures/two.pgm
scale() { python3 -c 'import json, sys
for run in json.load(open(sys.argv[1]))["runs"]:
  print(run["name"], run["scale_estimated"], abs(run["resolution"] * float(sys.argv[2]) - 1) < 0.005)
' "$1" "$2" | sort | tr '\n' ';'; }

# The picture is 0.0303 m per cell, whatever is guessed.
for guess in 0.02 0.1; do
  expect 0 "$roomgraph" compare one.yaml plan.pgm two.yaml --estimate-scale --resolution $guess -o o
  [[ $(scale o/comparison.json 33) == *'plan True True;'* ]] || fail "not the scale of the plan"
  [[ $(scale o/comparison.json 20) == 'one False True;'*'two False True;' ]] || fail "not as given"
  grep -qE '^plan: 0\.030[0-9]+ m per cell, estimated' out || fail "the scale is not told"
  [ ! -s err ] || fail "something went to stderr"
done

# Neither the order nor the number of threads changes a byte.
expect 0 "$roomgraph" compare two.yaml one.yaml plan.pgm --estimate-scale --resolution 0.1 -o o2 \
  --threads 1 -q
[ ! -s out ] || fail "not quiet"
diff -r o o2

# Without the option the picture is taken as it is; as the reference it is estimated, too.
expect 0 "$roomgraph" compare one.yaml two.yaml plan.pgm --resolution 0.02 -o as_it_is
one_line err plan.pgm site
expect 0 "$roomgraph" compare one.yaml two.yaml --reference plan.pgm --estimate-scale -o reference
[[ $(scale reference/comparison.json 33) == *'plan True True;'* ]] || fail "no scaled reference"

# Another building fits at no scale.
sample=$source_dir/share/roomgraph/maps/office.gridmap.gz
expect 0 "$roomgraph" compare "$sample" "$sample" plan.pgm --estimate-scale -o other
one_line err plan.pgm 'at no scale'
grep -q '"left_out": \[$' other/comparison.json || fail "the plan is not left out"
expect 3 "$roomgraph" compare "$sample" "$sample" plan.pgm --estimate-scale -o other \
  --fail-on not-same-site
expect 1 "$roomgraph" compare "$sample" --reference plan.pgm --estimate-scale -o other
one_line err plan.pgm 'at no scale'
plain blank.pgm 377
expect 1 "$roomgraph" compare one.yaml two.yaml blank.pgm --estimate-scale -o blank
one_line err blank.pgm 'no wall'

# Where no map tells a scale, pictures share one that is usual, and no gate judges its metres.
for option in "" --estimate-scale; do
  expect 0 "$roomgraph" compare pictures/one.pgm pictures/two.pgm $option -o usual
  grep -q 'cells, and the true scale may be' out || fail "cells are not told"
  one_line err 'no map tells the scale'
done
expect 3 "$roomgraph" compare pictures/one.pgm pictures/two.pgm -o usual --fail-above 100
grep -q '^roomgraph: one: .* cannot be told in metres' err || fail "metres are judged"

# What the option cannot do.
expect 2 "$roomgraph" compare one.yaml two.yaml --estimate-scale -o bad
one_line err picture
expect 2 "$roomgraph" compare one.yaml plan.pgm --estimate-scale --aligned -o bad
[ ! -e bad/comparison.json ] || fail "a comparison all the same"
