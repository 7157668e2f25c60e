# What CI jobs are made of: share/roomgraph/ci/gate, the action and the template, held to the program's help.
. "$(dirname "$0")/common.sh"
gate=$source_dir/share/roomgraph/ci/gate
maps=$source_dir/share/roomgraph/maps
mkdir "$work/bin" "my record"
ln -s "$roomgraph" "$work/bin/roomgraph"
export PATH=$work/bin:$PATH
for i in 1 2; do cp "$maps/office_run$i.simplemap.gz" "my record/run$i.simplemap.gz"; done
for i in 3 4; do cp "$maps/office_run$i.simplemap.gz" "tonight $i.simplemap.gz"; done
export ROOMGRAPH_RECORD='my record/*.gz' ROOMGRAPH_CACHE=pairs

# A passing gate says by how much, a failing one where; both below GitHub's job.
export GITHUB_STEP_SUMMARY=$work/shown.md
ROOMGRAPH_CANDIDATE='tonight 3.simplemap.gz' ROOMGRAPH_FAIL_ABOVE=5 expect 0 "$gate"
grep -q '^## The gate passes: tonight 3$' shown.md || fail "no heading"
grep -qE '^- tonight 3: its map error .* below 5 m$' shown.md || fail "does not say by how much it passes"
cmp -s results/summary.md shown.md || fail "another summary"
[ -n "$(ls pairs)" ] || fail "no pair is kept"
ROOMGRAPH_CANDIDATE='tonight*' ROOMGRAPH_FAIL_ABOVE=0.2 ROOMGRAPH_FAIL_ON=broken ROOMGRAPH_OUTPUT=other expect 3 "$gate"
grep -q '^## The gate fails: tonight 4 and tonight 3$' shown.md || fail "two maps are not judged"
grep -q '^- tonight 4: its map error ' shown.md || fail "no figure"
[ -s other/junit.xml ] && [ -s other/report.html ] || fail "no results"

# Each of the other limits is asked for.
ROOMGRAPH_CANDIDATE='tonight 3.simplemap.gz' ROOMGRAPH_FAIL_WORSE_BY=0.01 ROOMGRAPH_FAIL_BELOW=99 expect 3 "$gate"
[ "$(grep -c '^- tonight 3: ' results/summary.md)" = 2 ] || fail "not both limits are asked"

# What is missing is told, and an earlier summary is not shown as if it were of this job.
ROOMGRAPH_CANDIDATE='missing.simplemap' ROOMGRAPH_FAIL_ABOVE=5 expect 3 "$gate"
grep -q missing.simplemap err || fail "does not name the missing map"
ROOMGRAPH_CANDIDATE='' expect 2 "$gate"
one_line err 'ROOMGRAPH_CANDIDATE names no map'
# A gate that no map can fail is none.
ROOMGRAPH_CANDIDATE='tonight*' expect 2 "$gate"
one_line err 'every map would pass: set a limit'
: > shown.md
ROOMGRAPH_CANDIDATE='tonight*' ROOMGRAPH_FAIL_ON=everything expect 2 "$gate"
[ ! -s shown.md ] && [ ! -e results/junit.xml ] || fail "shows the summary of an earlier job"
# A name that begins with a dash is no option.
cp 'tonight 3.simplemap.gz' ./-3.simplemap.gz
ROOMGRAPH_CANDIDATE='-3*' ROOMGRAPH_FAIL_ABOVE=5 expect 0 "$gate"

# The options that it calls are the program's, and what it reads is what the jobs set.
"$roomgraph" compare --help > help
grep -oE -- '(ask |  )--[a-z-]+' "$gate" | grep -oE -- '--[a-z-]+' | sort -u > asked
[ "$(wc -l < asked)" -ge 6 ] || fail "finds no options in the gate"
while read -r option; do grep -qE -- "(^| )$option( |$)" help || fail "compare has no $option"; done < asked
grep -oE '^#   ROOMGRAPH.*|^#                            .*' "$gate" | grep -oE 'ROOMGRAPH_[A-Z_]+' | sort -u > told
grep -v '^#' "$gate" | grep -oE 'ROOMGRAPH_[A-Z_]+' | sort -u | diff told - || fail "the gate's text and its variables differ"
for job in "$source_dir/action.yml" "$source_dir/share/roomgraph/ci/gitlab.yml"; do
  grep -oE '^ +ROOMGRAPH_[A-Z_]+:' "$job" | tr -d ' :' | sort -u | diff told - || fail "$job sets others"
done
# The action names each thing that --fail-on takes.
for thing in $(tr -d '\n' < help | grep -oE -- '--fail-on LIST .*--junit' | grep -oE "'[a-z-]+'" | tr -d "'"); do
  sed -n '/fail-on:/,/description/p' "$source_dir/action.yml" | grep -qE "[ ;]$thing[,.]" || fail "the action does not name $thing"
done
# Inputs of the action are those that it uses, and docs/ci.md names no other.
sed -n '/^inputs:/,/^runs:/p' "$source_dir/action.yml" | grep -oE '^  [a-z-]+:' | tr -d ' :' | sort > inputs
grep -oE 'inputs\.[a-z-]+' "$source_dir/action.yml" | sed 's/inputs\.//' | sort -u | diff inputs - || fail "inputs differ"
sed -n '/with:/,/```/p' "$source_dir/docs/ci.md" | grep -oE '^ +(record|candidate|fail-[a-z]+[a-z-]*|output|packages):' |
  tr -d ' :' | sort -u | while read -r name; do grep -qx "$name" inputs || fail "docs/ci.md has the input $name"; done
for variable in $(grep -oE 'ROOMGRAPH_[A-Z_]+' "$source_dir/docs/ci.md" | sort -u); do
  grep -qx "$variable" told || fail "docs/ci.md has the variable $variable"
done
# The image is made of what scripts/package writes.
for package in $(grep -oE '(python3-)?roomgraph_\*\.deb' "$source_dir/Dockerfile" | sed 's/_\*.*//' | sort -u); do
  grep -qE "PACKAGE_NAME $package\$|PACKAGE_NAME $package\)" "$source_dir/cmake/RoomgraphPackages.cmake" ||
    fail "there is no package $package"
done
