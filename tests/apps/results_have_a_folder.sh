# Where no folder is named, the results of a command lie in one of its own, and nothing beside it.
. "$(dirname "$0")/common.sh"
mkdir here
cd here
rooms ../a.pgm
cp ../a.pgm ../b.pgm
"$roomgraph" extract ../a.pgm --resolution 0.05 --format json > ../out
[ "$(ls)" = roomgraph-extract ] || fail "extract leaves $(ls)"
[ "$(ls roomgraph-extract)" = a.json ] || fail "extract writes $(ls roomgraph-extract)"
"$roomgraph" compare ../a.pgm ../b.pgm --resolution 0.05 -q
[ "$(ls | tr '\n' ' ')" = 'roomgraph-compare roomgraph-extract ' ] || fail "compare leaves $(ls)"
[ -f roomgraph-compare/report.html ] || fail "compare writes no report"
"$roomgraph" stability ../a.pgm --resolution 0.05 --repeats 1 --distances 1 --percents 2 -q
[ "$(ls | tr '\n' ' ')" = 'roomgraph-compare roomgraph-extract roomgraph-stability ' ] ||
  fail "stability leaves $(ls)"
for command in extract compare stability; do
  "$roomgraph" "$command" --help > ../help
  grep -q "roomgraph-$command)$" ../help ||
    fail "$command does not tell its folder"
done
# A call that writes nothing leaves no folder behind, and none that was there goes.
mkdir there
for folder in none there; do
  expect 1 "$roomgraph" extract nothing.yaml -o "$folder"
  expect 1 "$roomgraph" check nothing.simplemap -o "$folder"
done
[ ! -e none ] && [ -d there ] || fail "an empty folder is left, or a user's is gone"
