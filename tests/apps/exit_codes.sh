# 0 for success and help, 1 for data that cannot be used, 2 for a call that makes no sense.
. "$(dirname "$0")/common.sh"
rooms a.pgm

expect 0 "$roomgraph" --help
expect 0 "$roomgraph" extract --help
expect 0 "$roomgraph" --version
expect 0 "$roomgraph" extract a.pgm -o o
expect 1 "$roomgraph" extract missing.gridmap -o o
one_line err missing.gridmap

expect 2 "$roomgraph"
grep -q "compare  *Rank several maps" err || fail "the commands are not named"
expect 0 "$roomgraph" help
cp out help
expect 0 "$roomgraph" --help
cmp out help
expect 0 "$roomgraph" help extract
grep -q "roomgraph extract \[OPTIONS\] MAP" out || fail "the help is of another command"
expect 2 "$roomgraph" help zzz
one_line err "there is no command 'zzz'"
expect 2 "$roomgraph" extract
one_line err MAP
expect 2 "$roomgraph" exctract a.pgm
one_line err "'exctract'" "did you mean 'extract'?"
expect 2 "$roomgraph" zzz
one_line err "there is no command 'zzz'"
expect 2 "$roomgraph" extract a.pgm --resolutoin=0.1
one_line err "did you mean '--resolution'?"
expect 2 "$roomgraph" extract a.pgm --no-such-option
one_line err --no-such-option
expect 2 "$roomgraph" extract a.pgm --format pdf
one_line err pdf geojson
expect 2 "$roomgraph" extract a.pgm --preset fast
one_line err fast paper
expect 2 "$roomgraph" extract a.pgm --resolution 0
one_line err resolution "use "
expect 2 "$roomgraph" extract a.pgm --set find_rooms.no_such_key=1
one_line err find_rooms no_such_key
expect 2 "$roomgraph" extract a.pgm --set nonsense
one_line err nonsense
expect 2 "$roomgraph" extract a.pgm --room-width 2 --alpha-px2 200
one_line err --room-width --alpha-px2
expect 2 "$roomgraph" extract a.pgm --config missing.ini
one_line err missing.ini

# What is no map is named, with the program that opens it.
expect 0 "$roomgraph" extract a.pgm --format all -o written
opened_by() {  # FILE TEXT...
  expect 1 "$roomgraph" extract "$1" -o none
  one_line err "$@"
}
opened_by written/a.json "is a graph, and no map" "roomgraph info"
opened_by written/a.geojson "is GeoJSON" QGIS
opened_by written/a.graphml "is a graph, and no map" Gephi
opened_by written/a.osm JOSM
opened_by written/a.svg "is a drawing, and no map" browser
printf '{"format": "roomgraph/check", "version": 1}\n' > run.check.json
opened_by run.check.json "no map" browser
printf '{"format": "roomgraph/site", "version": 1}\n' > site.json
opened_by site.json "no map" --names
opened_by written/a.roomgraph "is a graph, and no map" RawLogViewer
opened_by written/a.3Dscene "is a scene" SceneViewer3D
printf '<!DOCTYPE html>\n' > page.html
opened_by page.html browser
printf '# message formats\nPARAM laser_front_laser_resolution 1.0 nohost 0\nFLASER 3 1 2 3 0 0 0\n' > drive.log
opened_by drive.log CARMEN carmen2simplemap
printf '# time x y z qx qy qz qw\n1.5 0 0 0 0 0 0 1\n' > run.tum
opened_by run.tum "is a trajectory"
printf '1 0 0 0 0 1 0 0 0 0 1 0\n' > run.kitti
opened_by run.kitti "is a trajectory"
printf '{"format": "roomgraph/archive", "version": 1}\n' > history.json
opened_by history.json "is a result of roomgraph" editor
printf 'rank,name,file\n1,"a",a.pgm\n' > comparison.runs.csv
opened_by comparison.runs.csv "is a table" spreadsheet
printf 'PK\003\004\024\000' > comparison.a.evo.zip
opened_by comparison.a.evo.zip evo_res
printf 'VERTEX_SE2 0 0 0 0\n' > site.g2o
opened_by site.g2o g2o_viewer
printf '<?xml version="1.0"?>\n<testsuites tests="1">\n' > junit.xml
opened_by junit.xml JUnit
printf '## The gate passes: a\n\n' > s.md
opened_by s.md "the summary of a gate" editor
printf '## 2 maps compared\n\n' > t.md
opened_by t.md "a summary of a comparison" editor
printf 'version = "1.7.0"\n\n[maps."a.yaml"]\n' > comparison.maps.toml
opened_by comparison.maps.toml "with 'maps'"
printf 'translation:\n  x: 0\nroot_frame: site\n' > a.pose.yaml
opened_by a.pose.yaml "the map beside it"
printf '{"site":"S","key":"0"}\n' > tasks.jsonl
opened_by tasks.jsonl "roomgraph task"
expect 0 "$roomgraph" config
cp out options.ini
opened_by options.ini --config
expect 0 "$roomgraph" archive kept.db add a.pgm
opened_by kept.db "is an archive" "roomgraph archive"
printf 'Scene of a play\n' > text.txt
opened_by text.txt "is not a map of a known kind"

for command in extract check convert "archive kept.db report"; do
  expect 2 "$roomgraph" $command a.pgm -o ''
  one_line err "--output: is empty"
done

expect 2 "$roomgraph" compare a.pgm b.pgm --junit --summary s.md
one_line err "--junit: needs a value, and '--summary' is an option"
expect 2 "$roomgraph" compare a.pgm b.pgm --candidate -o c
one_line err "--candidate: needs a value"

touch file
expect 1 "$roomgraph" extract a.pgm -o file/below
one_line err file/below
for option in --resolution --room-width --alpha-px2 --config; do
  expect 2 "$roomgraph" extract a.pgm "$option" '' -o o
  one_line err "roomgraph:"
done

expect 2 "$roomgraph" compare a b --fail-below 101
one_line err "Value 101 not in range 0 to 100 "
