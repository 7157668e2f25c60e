# `compare --site-maps` writes ROS maps that lie in one frame, and what the viewer "maps" needs.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps

mkdir odd
cp "$maps/office_run2.simplemap.gz" 'odd/run "2".simplemap.gz'
expect 0 "$roomgraph" compare "$maps"/office_run[13].simplemap.gz 'odd/run "2".simplemap.gz' -o o \
  --site-maps
for run in office_run1 office_run3 run__2_; do
  for end in yaml pgm pose.yaml; do
    grep -qF "o/comparison.$run.$end" out || fail "no $run.$end"
    grep -q "^\"files\": .*\"comparison.$run.$end\"" o/comparison.json || fail "$end is not listed"
  done
  grep -qF "[maps.\"comparison.$run.yaml\".meta]" o/comparison.maps.toml || fail "$run has no session"
  [ -f "o/comparison.$run.pgm" ] || fail "no picture of $run"
done
[ "$(grep -c '^image_path' o/comparison.maps.toml)" -eq 3 ] || fail "not three maps in the session"

# They lie in one frame: taken as they are, their free space is the same.
expect 0 "$roomgraph" compare --aligned o/comparison.{office_run1,office_run3,run__2_}.yaml -o a -q
grep -o '"overlap": *[0-9.]*' a/comparison.json | awk -F: '{ if ($2 < 0.7) exit 1; n++ } END { exit n != 3 }' ||
  fail "not aligned"

# A map of that name is not replaced.
cp o/comparison.run__2_.* .
expect 2 "$roomgraph" compare --site-maps comparison.run__2_.yaml o/comparison.office_run1.yaml \
  'odd/run "2".simplemap.gz' -o . -q
grep -q 'would replace a file that is read' err || fail "a map was replaced"
