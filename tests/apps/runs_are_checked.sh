# `roomgraph check` tells of each run by itself.
. "$(dirname "$0")/common.sh"

maps=$source_dir/share/roomgraph/maps
expect 0 "$roomgraph" check "$maps"/office_run1.simplemap.gz "$maps"/office_run2.simplemap.gz -o results
[ "$(grep -c '^office_run[12]: ' out)" -eq 2 ] || { cat out; fail "not one line a run"; }
[ "$(grep '^  ' out)" = "$(printf '  results/office_run%s\n' 1.check.json 1.check.html 2.check.json 2.check.html)" ] ||
  { cat out; fail "not each file"; }
python3 - results/office_run1.check.json <<'P'
import json, sys
check = json.load(open(sys.argv[1]))
assert check["format"] == "roomgraph/check" and check["name"] == "office_run1", check
assert 0 <= check["seen_twice"] <= 1 and check["path"][0]["key_frame"] == 0, check
error = check["self_error_m"]
assert error is None or check["self_error_low_m"] <= error <= check["self_error_high_m"], check
P
grep -q '<h1>office_run1: no fault found</h1>' results/office_run1.check.html || fail "no page"

# The same bytes each time, and on any number of threads.
expect 0 "$roomgraph" check "$maps"/office_run1.simplemap.gz "$maps"/office_run2.simplemap.gz -o again -q --threads 1
[ ! -s out ] || fail "quiet is not quiet"
diff -r results again || fail "another result"

# Who extracts a graph from scans is told that they say how good the map is.
expect 0 "$roomgraph" extract "$maps"/office_run1.simplemap.gz "$maps"/office.gridmap.gz -o graphs --format json
[ "$(grep -c "^To see how good this run is: roomgraph check '$maps/office_run1.simplemap.gz'$" out)" -eq 1 ] || { cat out; fail "one of the two maps has scans"; }

# A map without scans tells nothing, which is no error but for a gate.
expect 0 "$roomgraph" check "$maps"/office.gridmap.gz -o grid
grep -q 'cannot tell: it has no scans, and its map alone says little' out || fail "more is told of a grid than is known"
grep -q '"self_error_m": null' grid/office.check.json || fail "an error is told of a grid"
grep -q '"name":"wall_doubling"' grid/office.check.json || fail "nothing is told of the walls"
expect 3 "$roomgraph" check "$maps"/office.gridmap.gz -o grid --fail-above 1 --junit grid.xml --summary grid.md
grep -q 'failures="1"' grid.xml || fail "no failure in JUnit's file"
grep -q 'cannot tell' grid.md || fail "no summary"
expect 3 "$roomgraph" check "$maps"/office.gridmap.gz -o grid --fail-on broken,doubled

# The scans of each break and of each place that is drawn twice, where asked for.
expect 0 "$roomgraph" check "$maps"/office_run?.simplemap.gz -o logs -q --break-files
python3 - logs/*.check.json <<'P'
import json, os, sys
for file in sys.argv[1:]:
    check = json.load(open(file))
    for kind, found in (("break", check["breaks"]), ("doubled", check["doubled"])):
        for i, one in enumerate(found, 1):
            stem = f"{file[:-5]}.{kind}{i}"
            assert os.path.getsize(stem + ".rawlog") > 100, stem
            has_fit = kind == "doubled" or one["shift_m"] is not None
            assert os.path.exists(stem + ".untorn.rawlog") == has_fit, stem
P
ls logs/*.rawlog > /dev/null || fail "no run has a break or is drawn twice: nothing was tested"

# What cannot be read is one line, and the others are checked all the same.
echo junk > junk.simplemap
expect 1 "$roomgraph" check junk.simplemap "$maps"/office_run1.simplemap.gz -o mixed -q --junit mixed.xml --summary mixed.md
one_line err junk.simplemap
grep -q '| junk.simplemap | .*could not be read' mixed.md && grep -q 'tests="2" failures="1"' mixed.xml || fail "what could not be read passes the gate"
[ -s mixed/office_run1.check.json ] || fail "the other run was not checked"
expect 2 "$roomgraph" check
expect 0 "$roomgraph" check "$maps"/office_run1.simplemap.gz -o mixed -q --fail-on broken,doubled
expect 2 "$roomgraph" check "$maps"/office_run1.simplemap.gz --fail-on rooms
expect 2 "$roomgraph" check "$maps"/office_run1.simplemap.gz --fail-above nan
for list in broken,,doubled ,broken broken, ''; do
  expect 2 "$roomgraph" check "$maps"/office_run1.simplemap.gz --fail-on "$list"
  one_line err --fail-on "'' is not one of broken and doubled"
done
# An option of no use is told, by other commands, too.
for options in "--layer nosuch" "--resolution 10"; do
  # shellcheck disable=SC2086
  expect 0 "$roomgraph" check "$maps"/office_run1.simplemap.gz -o mixed $options
  one_line err "note: " "${options%% *}" "not used"
done
for runs in "office_run1" "office_run1 office_run2"; do
  files=()
  for run in $runs; do files+=("$maps/$run.simplemap.gz"); done
  expect 0 "$roomgraph" repair "${files[@]}" -o unused --layer nosuch
  grep -q 'note: --layer is for metric maps' err || fail "an unused layer is not told"
done
# It is of use where one of the maps needs it.
rooms a.pgm
for maps in "a.pgm:0" "grid.gridmap.gz:1" "a.pgm grid.gridmap.gz:0"; do
  cp "$source_dir/share/roomgraph/maps/office.gridmap.gz" grid.gridmap.gz
  # shellcheck disable=SC2086
  expect 0 "$roomgraph" extract ${maps%:*} --resolution 0.05 -o use --format json
  [ "$(grep -c -- '--resolution' err)" -eq "${maps#*:}" ] || { cat err; fail "${maps%:*}: told wrongly"; }
done
