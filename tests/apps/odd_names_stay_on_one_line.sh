# Nothing of a file's name steers the terminal, or turns the order of its letters.
. "$(dirname "$0")/common.sh"
name=$'x\e[31m\xc2\x9b31m\xe2\x80\xae\n\xff.pgm'
safe='x?[31m?31m???.pgm'
rooms "$name"
expect 0 "$roomgraph" extract "$name" -o o -v
grep -qF "$safe" out err || fail "does not name the file"
expect 0 "$roomgraph" info "$name"
grep -qF "$safe" out || fail "info does not name the file"
cat out err > said
expect 1 "$roomgraph" extract "no $name" -o o
one_line err "no $safe"
expect 1 "$roomgraph" compare "no $name" "nor $name" -o o
cat out err >> said
if LC_ALL=C grep -qP '[^\x20-\x7e\n]' said; then cat -v said; fail "odd characters are shown"; fi
