# What a comparison is judged by can be set, stands in its file, and comes from there again.
. "$(dirname "$0")/common.sh"
maps=("$source_dir"/share/roomgraph/maps/office_run?.simplemap.gz)
expect 0 "$roomgraph" compare "${maps[@]}" -o plain -q
expect 0 "$roomgraph" compare "${maps[@]}" -o set -q \
  --set run_score.scale=2 --set run_score.min_share=0.3 --set site_breaks.min_shift=30 \
  --set site_breaks.min_rotation=0.5
grep -q '"run_score":{"scale":2,"min_share":0.3},"site_breaks":{"min_shift":30,"min_rotation":0.5}' \
  set/comparison.json || fail "the options are not in the file"
python3 - plain/comparison.json set/comparison.json <<'P'
import json, math, sys
plain, other = (json.load(open(name)) for name in sys.argv[1:])
assert plain["breaks"] and not other["breaks"], "a small jump is a break"
for run in other["runs"]:
    assert abs(run["score"] - 100 * math.exp(-run["map_error_m"] / 2)) < 0.01, run["name"]
P

# The same by way of the file of the comparison, and of an ini file.
expect 0 "$roomgraph" compare "${maps[@]}" -o again -q --config set/comparison.json
diff -r set again
"$roomgraph" config --config set/comparison.json > a.ini
expect 0 "$roomgraph" compare "${maps[@]}" -o ini -q --config a.ini
diff -r set ini

# One file of options serves all commands; what does not matter to one cannot be set for it.
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o one --format json -q --config a.ini
expect 2 "$roomgraph" extract a.pgm -o one --set run_score.scale=2
one_line err run_score

expect 2 "$roomgraph" compare "${maps[@]}" --set run_score.scale=0
one_line err "[run_score] scale = 0" 0.001 1000
printf '[compare]\naligned = true\nestimate_scale = true\n' > both.ini
expect 2 "$roomgraph" compare "${maps[@]}" --config both.ini
one_line err compare.aligned compare.estimate_scale
expect 2 "$roomgraph" compare "${maps[@]}" --config <(echo '{"format": "roomgraph/comparison"}')

# Only what is asked for is written.
expect 0 "$roomgraph" compare "${maps[@]}" -o some -q --format csv,json
[ "$(ls some | tr '\n' ' ')" = 'comparison.json comparison.rooms.csv comparison.runs.csv ' ] ||
  fail "other files than those that were asked for"
cmp plain/comparison.runs.csv some/comparison.runs.csv
expect 2 "$roomgraph" compare "${maps[@]}" --format json,htm
one_line err "'htm'" report geojson

# What is odd about several maps is told once.
cp a.pgm b.pgm
expect 0 "$roomgraph" compare a.pgm b.pgm -o odd
[ "$(grep -c 'note: no map tells the scale' err)" -eq 1 ] || fail "a note is told twice"
grep -q '(and 1 more note: see --verbose)$' err
expect 0 "$roomgraph" compare a.pgm b.pgm -o odd --verbose
[ "$(grep -c 'note: no map tells the scale' err)" -eq 2 ] || fail "a note is missing"
