# The program's README shows its real help.
. "$(dirname "$0")/common.sh"
"$source_dir/scripts/generate" "$roomgraph" "$work"
cmp README.md "$source_dir/apps/roomgraph/README.md" ||
  fail "run scripts/generate to bring apps/roomgraph/README.md up to date"
grep -q -- '--alpha-px2' README.md || fail "the README has no help in it"
