# The runs of a comparison have different names, whatever the files are called, and all results have
# the same ones.
. "$(dirname "$0")/common.sh"
rooms run.pgm
mkdir a b
cp run.pgm 'run#2.pgm'
cp run.pgm 'run#2#2.pgm'
cp run.pgm a/run.pgm
cp run.pgm b/run.pgm
cp run.pgm $'caf\xe9.pgm'   # no UTF-8, and so is the next one
cp run.pgm $'caf\xe8.pgm'

# names FILE...: of the runs of a comparison, which must be those of its tables and of its report.
names() {
  expect 0 "$roomgraph" compare "$@" -o o -q
  python3 - <<'P'
import csv, json
runs = json.load(open("o/comparison.json", encoding="utf-8"))["runs"]
names = [run["name"] for run in runs]
with open("o/comparison.runs.csv", encoding="utf-8", newline="") as table:
    rows = list(csv.DictReader(table))
assert [row["name"] for row in rows] == names, rows
assert [row["file"] for row in rows] == [run["file"].split("/")[-1] for run in runs], rows
with open("o/comparison.rooms.csv", encoding="utf-8", newline="") as table:
    assert {row["run"] for row in csv.DictReader(table)} <= set(names)
report = open("o/report.html", encoding="utf-8").read()
assert all(name in report for name in names), names
print(*sorted(names))
P
}

same() { [ "$1" = "$2" ] || fail "the names are '$1', not '$2'"; }

same "$(names run.pgm run.pgm 'run#2.pgm')" 'run run#2 run#3'
same "$(names 'run#2.pgm' run.pgm run.pgm)" 'run run#2 run#3'
same "$(names 'run#2.pgm' 'run#2.pgm' 'run#2#2.pgm' run.pgm)" 'run run#2 run#2#2 run#2#3'
same "$(names a/run.pgm b/run.pgm)" 'a/run b/run'
# The reference among the runs is not compared with itself.
same "$(names 'run#2.pgm' run.pgm --reference run.pgm)" 'run run#2'
expect 2 "$roomgraph" compare run.pgm --reference run.pgm -o o
same "$(names $'caf\xe9.pgm' run.pgm $'caf\xe8.pgm')" $'caf\xef\xbf\xbd caf\xef\xbf\xbd#2 run'
