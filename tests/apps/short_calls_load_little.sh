# A command loads MRPT's large libraries only where it needs them, and says so where they are not
# there. The program finds them by its own place, wherever that is.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps
name=libroomgraph_with_mrpt.so

ldd "$roomgraph" > linked
if grep -E 'libmrpt|libopencv|libglog|libcholmod' linked; then fail "these are loaded by every call"; fi
# Of what the loader does.
loaded() { LD_DEBUG=files LD_DEBUG_OUTPUT="$work/debug" "$roomgraph" "$@" > out 2> err || fail "$*"
           cat "$work"/debug.* > loaded; rm "$work"/debug.*
           grep -qE 'libroomgraph_with_(mrpt|ceres)|libopencv' loaded; }
loaded extract "$maps/office.simplemap.gz" --format json -o built ||
  fail "this test sees nothing"
"$roomgraph" extract "$maps/office.yaml" --format roomgraph -o built -q
"$roomgraph" compare "$maps/office.gridmap.gz" "$maps"/office_run1.simplemap.gz -o compared -q
library=$(grep -oE "[^ ]*/$name" loaded | head -n 1)
for call in --version --help 'compare --help' config "info $maps/office.yaml" \
    "info $maps/office.gridmap.gz" "info $maps/office_run1.simplemap.gz" 'info built/office.json' 'info built/office.roomgraph' \
    'info compared/comparison.json' 'info compared/comparison.roomgraph' \
    "extract $maps/office.yaml --format json,svg,png,graphml,geojson,labels,osm -o o"; do
  if loaded $call; then fail "'$call' loads large libraries"; fi
done

# Without the library, what does not need it works.
mkdir alone
cp "$roomgraph" alone/roomgraph
alone/roomgraph extract "$maps/office.yaml" --format json -o o -q 2> err
expect 1 alone/roomgraph extract "$maps/office.simplemap.gz" --format json -o o -q
one_line err "$name" "install roomgraph again"

# Program and library may be moved together.
there=$(realpath --relative-to="$(dirname "$roomgraph")" "$(dirname "$library")")
mkdir -p moved/bin "moved/bin/$there"
cp "$roomgraph" moved/bin/roomgraph
cp "$(dirname "$library")"/*.so "moved/bin/$there"
ln -s moved/bin/roomgraph link
expect 0 ./link extract "$maps/office.simplemap.gz" --format json -o moved -q
cmp built/office.json moved/office.json
