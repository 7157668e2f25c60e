# compare --format evo: paths in the frame of the site, and their errors as evo has them.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps
cp "$maps/office_run1.simplemap.gz" "$maps/office.gridmap.gz" .
mkdir b && cp "$maps/office_run3.simplemap.gz" b/office_run1.simplemap.gz

expect 0 "$roomgraph" compare office_run1.simplemap.gz b/office_run1.simplemap.gz office.gridmap.gz -q -o o \
  --format json,evo
ls o | sort > written
[ "$(tr '\n' ' ' < written)" = "comparison.b_office_run1.evo.zip comparison.b_office_run1.tum comparison.json \
comparison.office_run1.evo.zip comparison.office_run1.tum " ] || { cat written >&2; fail "not two files for each run"; }
python3 - <<'P'
import array, io, json, math, zipfile
ROUNDING = 0.000051  # of comparison.json
comparison = json.load(open("o/comparison.json"))
assert sorted(comparison["files"]) == open("written").read().split(), comparison["files"]
for run in comparison["runs"]:
    if not run["path"]:
        continue
    name = run["name"].replace("/", "_")
    lines = [[float(word) for word in line.split()] for line in open(f"o/comparison.{name}.tum")
             if not line.startswith("#")]
    assert len(lines) == len(run["path"]) > 10
    for line, at in zip(lines, run["path"]):
        time, x, y, z, qx, qy, qz, qw = line
        assert abs(time - at["time"]) < 1e-5 and (x, y, z) == (at["x"], at["y"], 0)
        assert abs(math.remainder(2 * math.atan2(qz, qw) - at["phi"], 2 * math.pi)) < ROUNDING
    archive = zipfile.ZipFile(f"o/comparison.{name}.evo.zip")
    assert archive.testzip() is None
    npy = archive.read("error_array.npy")
    errors = array.array("d", npy[npy.index(b"\n") + 1:])
    known = [at["error_m"] for at in run["path"] if at["error_m"] is not None]
    assert len(errors) == len(known) and all(abs(a - b) < ROUNDING for a, b in zip(errors, known))
    rmse = json.loads(archive.read("stats.json"))["rmse"]
    assert abs(rmse - math.sqrt(sum(e * e for e in errors) / len(errors))) < 1e-9
    assert json.loads(archive.read("info.json"))["est_name"] == name + ".tum"
P

# Nothing of it where it is not named, and no map is replaced by it.
expect 0 "$roomgraph" compare office_run1.simplemap.gz office.gridmap.gz -q -o all
! ls all | grep -E 'tum|evo' || fail "all writes it, too"
expect 2 "$roomgraph" compare office_run1.simplemap.gz office.gridmap.gz -q -o all --format tum
one_line err "roomgraph, all or evo"
mv office_run1.simplemap.gz comparison.run.tum
cp comparison.run.tum run
expect 2 "$roomgraph" compare run comparison.run.tum office.gridmap.gz -q -o . --format evo
one_line err "would replace a file that is read"
cmp -s run comparison.run.tum || fail "a map was replaced"
