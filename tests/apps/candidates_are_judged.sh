# The gate of `roomgraph compare` judges the runs it is asked about, and nothing compared is no pass.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps
for i in 1 2 3 4; do cp "$maps/office_run$i.simplemap.gz" "run$i.simplemap.gz"; done
record=(run1.simplemap.gz run2.simplemap.gz run4.simplemap.gz)

# Of the sample runs, the third drifts and the fourth is torn; the first two are good.
expect 3 "$roomgraph" compare "${record[@]}" --candidate run3.simplemap.gz -o o --fail-worse-by 0.2 \
  --fail-on broken --junit o/junit.xml --summary o/summary.md
one_line err run3 "more than the median of the three best others"
tail -n 1 out | grep -q '^FAIL run3: .* more than the median' || fail "no verdict at the end"
python3 - <<'P'
import json, xml.etree.ElementTree as xml
gate = json.load(open("o/comparison.json"))["gate"]
assert not gate["passed"] and gate["candidates"] == ["run3"], gate
assert gate["asked"] == ["map error at most 0.2 m above the median of the three best others", "no break that is not slight"], gate
cases = xml.parse("o/junit.xml").getroot().findall(".//testcase")
assert [case.get("name") for case in cases] == ["run3"], cases
assert len(cases[0].findall("failure")) == 1
P
grep -q '^## The gate fails: ' o/summary.md || fail "no verdict in the summary"
[ "$(grep -c '^| ' o/summary.md)" = 5 ] || fail "not a row for each run"
grep -q 'The gate of run3 fails' o/report.html || fail "no verdict in the page"

# The same figures, another candidate: the torn run of the record is not its fault.
expect 0 "$roomgraph" report o/comparison.json -o o2 --candidate run1 --fail-worse-by 0.2 \
  --fail-above 0.1 --fail-on broken
tail -n 1 out | grep -q '^PASS run1: its map error of .* below 0.1 m' || fail "no verdict at the end"
grep -q 'The gate of run1 passes' o2/report.html || fail "no pass in the page"
expect 3 "$roomgraph" report o/comparison.json -o o2 --candidate run4 --fail-above 0.2
# A break of less than five degrees is slight: it is told, and fails no gate.
expect 0 "$roomgraph" report o/comparison.json -o o2 --candidate run4 --fail-on broken
grep -q '1 slight break is listed' o2/report.html || fail "the slight break is not told"
expect 3 "$roomgraph" report o/comparison.json -o o2 --fail-above 0.1
[ "$(wc -l < err)" = 2 ] || fail "not two runs above the limit"
expect 2 "$roomgraph" report o/comparison.json -o o2 --candidate run5
one_line err run5

# A candidate that is damaged, or of another building, does not pass.
rooms other.pgm
head -c 5000 run3.simplemap.gz > damaged.simplemap.gz
expect 3 "$roomgraph" compare run1.simplemap.gz run2.simplemap.gz --candidate damaged.simplemap.gz -o o
expect 3 "$roomgraph" compare run1.simplemap.gz run2.simplemap.gz --candidate other.pgm -o o \
  --resolution 0.05 --fail-above 1

# Nothing compared is no pass, whether a gate is asked or not.
expect 1 "$roomgraph" compare run1.simplemap.gz other.pgm --resolution 0.05 -o o
grep -q 'nothing was compared' err || fail "not said that nothing was compared"
expect 1 "$roomgraph" report o/comparison.json
expect 1 "$roomgraph" compare run1.simplemap.gz other.pgm --resolution 0.05 -o o --fail-above 1
expect 3 "$roomgraph" compare run1.simplemap.gz other.pgm --resolution 0.05 -o o --fail-on not-same-site
# A reference is no candidate, however it is spelled, and is not compared with itself; an empty name is no map.
expect 2 "$roomgraph" compare run1.simplemap.gz --candidate run2.simplemap.gz --reference ./run2.simplemap.gz -o o
expect 0 "$roomgraph" compare run1.simplemap.gz ./run2.simplemap.gz --reference run2.simplemap.gz -o o
[ "$(grep -c '^ .*run2' out)" = 1 ] || fail "the reference is compared with itself"
expect 1 "$roomgraph" compare "" run1.simplemap.gz run2.simplemap.gz -o o
expect 2 "$roomgraph" compare --candidate run1.simplemap.gz run1.simplemap.gz -o o
expect 2 "$roomgraph" compare "${record[@]}" -o o --junit run1.simplemap.gz

# Where nothing can be compared, no map is called bad: the gate has nothing to judge by.
expect 1 "$roomgraph" compare "$maps"/office_run4.simplemap.gz missing.simplemap --fail-on broken -o alone
grep -q 'nothing was compared' err || fail "it is not said that nothing was compared"
grep -q '"breaks": \[\]' alone/comparison.json || fail "a run alone has a break"
