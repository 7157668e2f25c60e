# `roomgraph-view --screenshot` draws without a display. The first argument is
# roomgraph-view, the third roomgraph.
. "$(dirname "$0")/common.sh"
unset DISPLAY WAYLAND_DISPLAY
view=$roomgraph compare=$3 maps=$source_dir/share/roomgraph/maps
command -v identify > /dev/null || { echo "skipped: no imagemagick"; exit 77; }

# pixels FILE COLOUR: how many there are
pixels() { convert "$1" -fill white +opaque "$2" -fill black -opaque "$2" -format '%[fx:(1-mean)*w*h]' info: | cut -d. -f1; }

expect 0 "$view" "$maps/office_run4.simplemap.gz" --key-frame 60 --screenshot one.png
[ "$(identify -format '%wx%h' one.png)" = 1280x860 ] || fail "size"
[ "$(pixels one.png 'rgb(200,30,30)')" -gt 100 ] || fail "no scan"
[ "$(pixels one.png 'rgb(0,110,82)')" -gt 100 ] || fail "no rooms"

expect 0 "$view" --break 1 --screenshot break.png --size 640 480 "$maps"/office_run[124].simplemap.gz
[ "$(identify -format '%wx%h' break.png)" = 640x480 ] || fail "size"
[ "$(pixels break.png 'rgb(0,130,90)')" -gt 100 ] || fail "no torn piece"

# One run is checked by itself: what it has drawn twice is shown in both poses.
expect 0 "$view" "$maps/office_run3.simplemap.gz" --break 1 --screenshot fault.png
[ "$(pixels fault.png 'rgb(0,130,90)')" -gt 100 ] || fail "no mended piece"

# What is read, or somebody else's, is not replaced; its own picture is.
cp "$maps"/office.yaml "$maps"/office.png . && cp office.png mine.png
for picture in office.png mine.png; do
  expect 2 "$view" office.yaml --screenshot $picture
  one_line err $picture "would replace" "choose another file with --screenshot"
  cmp $picture "$maps"/office.png || fail "$picture was replaced"
done
expect 2 "$view" office.yaml --screenshot one.simplemap.gz
one_line err one.simplemap.gz "must end in .png"
expect 0 "$view" office.yaml --screenshot one.png

# A stage takes the place of the graph: the obstacle cells are orange, and no vertex is there yet.
expect 0 "$view" "$maps/office.yaml" --stage 2 --screenshot stage.png
[ "$(pixels stage.png 'rgb(213,94,0)')" -gt 1000 ] || fail "no obstacles"
[ "$(pixels stage.png 'rgb(0,110,82)')" -eq 0 ] || fail "rooms in a stage before rooms"
expect 0 "$compare" extract "$maps/office.yaml" --format json -o graph
expect 1 "$view" graph/office.json --screenshot none.png
one_line err "is a graph" "give the map that it is of"
expect 2 "$view" "$maps/office.yaml" --stage 17 --screenshot none.png
one_line err --stage

expect 2 "$view" "$maps/office_run1.simplemap.gz" --break 1 --screenshot none.png
one_line err --break
grep -q "there is none" err || fail "a sound run has no break"
expect 2 "$view" "$maps/office_run4.simplemap.gz" --key-frame 120 --screenshot none.png
one_line err "the last one is 119"
expect 2 "$view" "$maps/office.yaml" --key-frame 0 --screenshot none.png
one_line err "no scans"

# A comparison, with its maps before or behind it; what cannot be drawn is told, and the rest is drawn.
mkdir moved; cp "$maps"/office_run[124].simplemap.gz moved
expect 0 "$compare" compare moved/*.gz -o results --quiet
mv moved/office_run4.simplemap.gz moved/gone; head -c 9000 moved/gone > moved/office_run4.simplemap.gz
expect 0 "$view" moved/*.gz "$maps/office.yaml" results/comparison.json --screenshot some.png
grep -q "office_run4.simplemap.gz: .*damaged" err || fail "the damaged map is not told"
grep -q "office.yaml: is none of the maps" err || fail "the other map is not told"
grep -q "the map office_run4.simplemap.gz is not drawn" err || fail "the missing map is not told"
[ "$(pixels some.png 'rgb(0,114,178)')" -gt 1000 ] || fail "the best run is not drawn"
expect 2 "$view" results/comparison.json results/comparison.json --screenshot none.png
one_line err "one comparison"

expect 2 "$view"
expect 2 "$view" "$maps/office_run4.simplemap.gz" --run 2 --screenshot none.png
expect 1 "$view" missing.simplemap --screenshot none.png
one_line err missing.simplemap
expect 1 "$view" "$maps/office_run4.simplemap.gz"
one_line err --screenshot
[ ! -e none.png ] || fail "a picture of nothing"
