# The runs of share/roomgraph/maps come out as they were made: their order, their errors, where they
# lie, and the break of one of them. What is true of them stands in office_runs.csv.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps

expect 0 "$roomgraph" compare "$maps"/office_run?.simplemap.gz -o o
[ ! -s err ] || fail "something went to stderr"
grep -q 'office_run1 is the best map' out || { cat out; fail "another verdict"; }
# The tutorial shows what comes out; its other figures are of programs that the tests need not have.
head -n 6 out | while IFS= read -r line; do
  grep -qxF -- "$line" "$source_dir/docs/tutorial.md" || fail "not in docs/tutorial.md: $line"
done
python3 - "$maps/office_runs.csv" o/comparison.json "$source_dir/docs/tutorial.md" <<'P'
import ast, csv, json, math, sys
truth = {row["run"]: row for row in csv.DictReader(open(sys.argv[1]))}
result = json.load(open(sys.argv[2]))
runs = {run["name"]: run for run in result["runs"]}
assert not result["left_out"] and runs.keys() == truth.keys(), runs.keys()

def number(run, column):
    return float(truth[run][column])

def pose(run):  # of its frame in that of the office
    return number(run, "x"), number(run, "y"), number(run, "phi")

def inverse(a):
    c, s = math.cos(a[2]), math.sin(a[2])
    return -c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]

def joined(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]

# The order, and the error within its interval.
asMade = sorted(truth, key=lambda run: number(run, "map_error_m"))
assert [run["name"] for run in result["runs"]] == asMade, result["runs"]
assert [run["rank"] for run in result["runs"]] == [1, 2, 3, 4], result["runs"]
for name, run in runs.items():
    assert run["meaningful"], run
    assert run["map_error_low"] <= number(name, "map_error_m") <= run["map_error_high"], run

# Each run lies where it should beside the first, which is sound; bent ones have no one pose.
site = joined(runs["office_run1"]["pose"], inverse(pose("office_run1")))  # site <- office
for name, run in runs.items():
    x, y, phi = joined(inverse(joined(site, pose(name))), run["pose"])
    phi = math.remainder(phi, 2 * math.pi)
    reach = 0.3 + 3 * number(name, "map_error_m")
    assert math.hypot(x, y) < reach and abs(phi) < 0.2, (name, x, y, phi)

# The break, and no other.
assert [found["run"] for found in result["breaks"]] == ["office_run4"], result["breaks"]
found = result["breaks"][0]
place = joined(site, (number("office_run4", "break_x"), number("office_run4", "break_y"), 0))
off = math.hypot(found["x"] - place[0], found["y"] - place[1])
assert off < 2, (found, place)
assert abs(found["rotation_deg"] - number("office_run4", "break_deg")) < 1, found
assert found["shift_m"] < 0.25, found

# The tutorial shows it, up to what another compiler may round otherwise.
def numbers(value):
    if isinstance(value, list):
        return [number for one in value for number in numbers(one)]
    return [value] if isinstance(value, (int, float)) else []

line = next(line for line in open(sys.argv[3], encoding="utf-8") if line.startswith("[{'run'"))
shown = ast.literal_eval(line)[0]
assert shown.keys() == found.keys(), shown
for a, b in zip(numbers([*shown.values()]), numbers([*found.values()])):
    assert math.isclose(a, b, abs_tol=0.001), (a, b, shown)
P

# A break of less than five degrees is told, and fails no gate; the limits of errors and scores do.
expect 0 "$roomgraph" compare "$maps"/office_run?.simplemap.gz -o gate --fail-on broken
grep -q '1 slight break is listed' out || { cat out; fail "the slight break is not told"; }
expect 3 "$roomgraph" compare "$maps"/office_run?.simplemap.gz -o gate --fail-below 30
one_line err office_run3 'below 30'
