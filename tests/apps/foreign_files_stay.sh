# Whatever a call would write, it takes the place of no file that it reads, of no other result, and of no map, graph, path
# or log that roomgraph has not written: one line says so before any work.
. "$(dirname "$0")/common.sh"
maps=$source_dir/share/roomgraph/maps
cp "$maps"/office_run1.simplemap.gz run1.simplemap.gz
cp "$maps"/office_run2.simplemap.gz run2.simplemap.gz
cp "$maps"/office.gridmap.gz other.gridmap.gz
mkdir before && cp ./*.gz before
unchanged() { for file in before/*; do cmp "$file" "$(basename "$file")" || fail "$file was replaced"; done; }
# refused TEXT... -- ARGUMENT...: the call is refused with one line, and nothing is written.
refused() {
  local texts=()
  while [ "$1" != -- ]; do texts+=("$1"); shift; done
  shift
  expect 2 "$roomgraph" "$@"
  one_line err "${texts[@]}"
  [ ! -e o ] || fail "a folder was made: $*"
  unchanged
}

# Files that an option names.
for option in --junit --summary; do
  refused run1.simplemap.gz "file that is read" $option -- check run1.simplemap.gz -o o $option run1.simplemap.gz
  refused other.gridmap.gz "a map" $option -- check run1.simplemap.gz -o o $option other.gridmap.gz
  refused other.gridmap.gz "a map" -- compare run1.simplemap.gz run2.simplemap.gz -o o $option other.gridmap.gz
  refused run1.simplemap.gz "file that is read" -- compare run1.simplemap.gz run2.simplemap.gz -o o \
    $option run1.simplemap.gz
done
printf '[load_grid]\nresolution = 0.05\n' > my.ini && cp my.ini before
refused my.ini "file that is read" -- check run1.simplemap.gz -c my.ini --junit my.ini -o o
printf 'name,x,y,yaw\ndock,0,0,0\n' > goals.csv && cp goals.csv before
refused goals.csv "has not written" -- check run1.simplemap.gz --summary goals.csv -o o
printf '{"type": "FeatureCollection", "features": []}\n' > route.geojson && cp route.geojson before
refused route.geojson "has not written" -- check run1.simplemap.gz --summary route.geojson -o o

# Two results of one name.
refused "--junit and --summary would both" ./x -- check run1.simplemap.gz --junit x --summary ./x -o o
refused run1.check.html "--junit" "would both" -- \
  check run1.simplemap.gz --junit o/run1.check.html -o o
refused "--names and --junit would both" -- \
  compare run1.simplemap.gz run2.simplemap.gz --names n.json --junit n.json -o o
refused "would both" comparison.run1.tum -- \
  compare run1.simplemap.gz run2.simplemap.gz --format evo --junit o/comparison.run1.tum -o o
refused "would both" break7 -- \
  compare run1.simplemap.gz run2.simplemap.gz --break-files --junit o/comparison.break7.rawlog -o o

# A report of a comparison.
expect 0 "$roomgraph" compare run1.simplemap.gz run2.simplemap.gz -o c -q --format json
cp c/comparison.json comparison && cp comparison before
refused comparison "file that is read" -- report comparison -o o --junit comparison
for map in run1.simplemap.gz other.gridmap.gz; do
  refused $map "would replace" -- report c/comparison.json -o o --summary $map
done
expect 0 "$roomgraph" report c/comparison.json -q

# Files of an archive.
expect 0 "$roomgraph" archive a.roomgraph add run1.simplemap.gz run2.simplemap.gz -q
cp a.roomgraph archive.db
for output in a.roomgraph archive.db run1.simplemap.gz other.gridmap.gz goals.csv; do
  refused $output --output -- archive a.roomgraph export -o $output
  refused $output --output -- archive a.roomgraph report -o $output
done
for time in first second; do
  for format in csv json prometheus; do
    expect 0 "$roomgraph" archive a.roomgraph export --format $format -o history.$format
    expect 0 "$roomgraph" archive a.roomgraph export --format $format -o $format.${format/prometheus/prom}
    expect 0 "$roomgraph" archive a.roomgraph export --format $format -o $format.txt
  done
  expect 0 "$roomgraph" archive a.roomgraph report -o report.html -q
done

# Results of fixed names: somebody else's stay, its own are written again.
for name in site.simplemap.gz run1.repaired.simplemap.gz; do
  mkdir -p p && cp run1.simplemap.gz p/$name
done
cp -r p p.before
expect 2 "$roomgraph" merge run1.simplemap.gz run2.simplemap.gz -o p
one_line err p/site.simplemap.gz "has not written" --output
expect 2 "$roomgraph" repair run1.simplemap.gz -o p
one_line err p/run1.repaired.simplemap.gz "has not written" --output
diff -r p p.before || fail "a map was replaced"
gunzip -c run1.simplemap.gz > plain.simplemap
zstd -q plain.simplemap -o packed.simplemap.zst
for kind in site.g2o run1.repaired.tum run1.loop_constraints.yaml; do
  mkdir -p "f/$kind" && echo mine > "f/$kind/$kind"
  expect 2 "$roomgraph" repair run1.simplemap.gz --format mola -o "f/$kind"
  one_line err "f/$kind/$kind" "has not written"
done
mkdir g && echo mine > g/comparison.run1.tum
expect 2 "$roomgraph" compare run1.simplemap.gz run2.simplemap.gz -o g --format evo
one_line err g/comparison.run1.tum "has not written"
echo mine > g/comparison.break3.rawlog
expect 2 "$roomgraph" compare run1.simplemap.gz run2.simplemap.gz -o g --break-files
one_line err g/comparison.break3.rawlog "has not written"
echo '{"type": "FeatureCollection"}' > g/other.geojson
expect 2 "$roomgraph" extract other.gridmap.gz -o g
one_line err g/other.geojson "has not written"
mkdir g/other && echo mine > g/other/01_grid.png
expect 2 "$roomgraph" extract other.gridmap.gz -o h --format json --stages g
one_line err g/other/01_grid.png "has not written"
for time in first second; do
  expect 0 "$roomgraph" merge run1.simplemap.gz run2.simplemap.gz -o own -q
  expect 0 "$roomgraph" repair run1.simplemap.gz run2.simplemap.gz -o own -q --format mola
  for run in plain.simplemap packed.simplemap.zst; do expect 0 "$roomgraph" repair $run -o own -q; done
  expect 0 "$roomgraph" check run1.simplemap.gz -o own -q --break-files --junit own/j.xml --summary own/s.md
  expect 0 "$roomgraph" compare run1.simplemap.gz run2.simplemap.gz -o own -q --format all,evo --site-maps \
    --break-files --names own/n.json
  expect 0 "$roomgraph" extract other.gridmap.gz -o own -q --format all --stages own/stages
  expect 0 "$roomgraph" carry goals.csv --from run1.simplemap.gz --to run2.simplemap.gz -o own -q
done
# One that was changed since then is no longer its own.
cp plain.simplemap own/plain.repaired.simplemap && printf x >> own/plain.repaired.simplemap
expect 2 "$roomgraph" repair plain.simplemap -o own
one_line err own/plain.repaired.simplemap "has not written"
# What was carried may be carried again; a table of that name that was not stays.
mkdir k && cp goals.csv k
expect 2 "$roomgraph" carry goals.csv --from run1.simplemap.gz --to run2.simplemap.gz -o k
one_line err k/goals.csv "has not written"
expect 0 cmp goals.csv k/goals.csv
for name in goals.txt goals sites.csv; do
  case $name in
    goals*) printf 'name,x,y\nmine,9,9\n' ;;
    *) printf 'id,name,kind,x,y\n1,mine,dock,9,9\n' ;;
  esac > k/$name
  cp goals.csv $name && cp k/$name kept
  expect 2 "$roomgraph" carry $name --from run1.simplemap.gz --to run2.simplemap.gz -o k
  one_line err k/$name "would replace a file that roomgraph has not written"
  cmp k/$name kept || fail "$name was replaced"
  for time in first second; do
    expect 0 "$roomgraph" carry $name --from run1.simplemap.gz --to run2.simplemap.gz -o own -q
  done
done
for name in sites.csv sites.txt; do
  printf 'site,robot,time,file\nlab,anna,,a.simplemap\n' > $name && cp $name before
  refused $name "has not written" -- archive a.roomgraph export -o $name
done

# A picture may have another name than its yaml.
for kind in pgm pnm; do
  mkdir -p zones/$kind && printf 'P5\n20 20\n255\n' > zones/$kind/picture.$kind
  head -c 400 /dev/zero >> zones/$kind/picture.$kind
  printf 'image: picture.%s\nresolution: 0.1\norigin: [-1, -1, 0]\nnegate: 0\n' $kind > zones/$kind/zone.yaml
  printf 'occupied_thresh: 0.65\nfree_thresh: 0.196\n' >> zones/$kind/zone.yaml
  for time in first second; do
    "$roomgraph" carry zones/$kind/zone.yaml --from run1.simplemap.gz --to run2.simplemap.gz -o zones/$kind.o -q ||
      [ $? -eq 1 ] || fail "a mask is not carried the $time time"
  done
  cp zones/$kind/picture.$kind zones/$kind.o/other.$kind
  sed -i s/picture/other/ zones/$kind/zone.yaml && cp zones/$kind/picture.$kind zones/$kind/other.$kind
  expect 2 "$roomgraph" carry zones/$kind/zone.yaml --from run1.simplemap.gz --to run2.simplemap.gz -o zones/$kind.o
  one_line err zones/$kind.o/other.$kind "has not written"
done

# A plan of many sites.
mkdir plan && printf 'site,file\nhall,%s\n' "$PWD/run1.simplemap.gz" > plan/tasks.jsonl
expect 2 "$roomgraph" plan plan/tasks.jsonl --archive a.roomgraph -o plan
one_line err plan/tasks.jsonl "file that is read"

# A name that is too long with what results add to it is told before the work.
long=$(printf 'x%.0s' {1..235})
cp run1.simplemap.gz "$long.simplemap.gz" || exit 77
refused "too long" "rename $long" -- repair "$long.simplemap.gz" -o o
refused "too long" -- compare "$long.simplemap.gz" run1.simplemap.gz --format all,evo --site-maps -o o
refused "too long" -- check run1.simplemap.gz --junit "$long$long" -o o
unchanged
