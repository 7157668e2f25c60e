# Text that does not arrive is an error: a cut ini file must not pass for a whole one.
. "$(dirname "$0")/common.sh"
rooms a.pgm
expect 0 "$roomgraph" extract a.pgm -o o

# unwritten ARGUMENTS...: with stdout on a full disk, then closed.
unwritten() {
  for stdout in '/dev/full' '&-'; do
    code=0
    eval '"$roomgraph" "$@" 2> err >'"$stdout" || code=$?
    [ "$code" -eq 1 ] || fail "exit code $code with stdout on $stdout: $*"
    tail -n 1 err > last   # behind what is said of the map
    one_line last "standard output"
  done
}
unwritten config
unwritten --help
unwritten info a.pgm o/a.json
unwritten score-rooms a.pgm a.pgm
unwritten extract a.pgm -o again
diff -r o again   # the results are there all the same
