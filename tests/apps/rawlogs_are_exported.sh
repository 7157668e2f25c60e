# `roomgraph export-rawlog` writes scans for MRPT's programs, `compare --break-files` those at breaks.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps

expect 0 "$roomgraph" export-rawlog "$maps"/office_run[12].simplemap.gz -o logs
[ "$(cat out)" = "$(printf 'logs/office_run1.rawlog\nlogs/office_run2.rawlog')" ] || fail "names"
# 120 key frames, an action and an observation each.
[ "$(gzip -dc logs/office_run1.rawlog | grep -ao CSensoryFrame | wc -l)" -eq 120 ] || fail "frames"
[ "$(gzip -dc logs/office_run1.rawlog | grep -ao CActionCollection | wc -l)" -eq 120 ] ||
  fail "actions"

expect 0 "$roomgraph" export-rawlog "$maps/office_run1.simplemap.gz" --from 50 --to 59 -o part
[ "$(gzip -dc part/office_run1.rawlog | grep -ao CSensoryFrame | wc -l)" -eq 10 ] || fail "stretch"

expect 1 "$roomgraph" export-rawlog "$maps/office_run1.simplemap.gz" --from 120 -o none
one_line err office_run1 'last key frame is 119'
expect 1 "$roomgraph" export-rawlog "$maps/office_run1.simplemap.gz" --to 120 -o none
expect 1 "$roomgraph" export-rawlog "$maps/office.gridmap.gz" -o none
one_line err office.gridmap.gz 'no key frames'
expect 2 "$roomgraph" export-rawlog "$maps/office_run1.simplemap.gz" --from 5 --to 4
expect 2 "$roomgraph" export-rawlog "$maps/office_run1.simplemap.gz" --from -1
[ -z "$(ls none)" ] || fail "something was written"

expect 0 "$roomgraph" compare "$maps"/office_run?.simplemap.gz -o o --break-files
for end in rawlog untorn.rawlog 3Dscene; do
  grep -qF "o/comparison.break1.$end" out || fail "no $end"
  gzip -t "o/comparison.break1.$end"
  grep -q "^\"files\": .*\"comparison.break1.$end\"" o/comparison.json || fail "$end is not listed"
  [ ! -e "o/comparison.break2.$end" ] || fail "more than the one break"
done
[ "$(gzip -dc o/comparison.break1.rawlog | grep -ao CSensoryFrame | wc -l)" -eq 20 ] || fail "20"
cmp -s o/comparison.break1.rawlog o/comparison.break1.untorn.rawlog && fail "one pose only"
expect 0 "$roomgraph" compare "$maps"/office_run[12].simplemap.gz -o p --break-files -q
[ -z "$(ls p | grep break)" ] || fail "files without a break"
