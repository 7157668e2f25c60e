# A disk that fails to read is no damage of an archive.
. "$(dirname "$0")/common.sh"
command -v strace > /dev/null || { echo "skipped: strace is not here"; exit 77; }
strace -o /dev/null true 2> /dev/null || { echo "skipped: strace may not trace here"; exit 77; }
rooms a.pgm
expect 0 "$roomgraph" archive a.db add a.pgm --resolution 0.05 --time 2026-11-22

# failing FILE FAULT COMMAND...: the program with that fault in its calls on the file.
failing() {
  strace -f -qq -o trace -P "$PWD/$1" -e "inject=$2" "$roomgraph" archive a.db "${@:3}"
}
faults=0
for ((n = 1; ; ++n)); do
  failing a.db "pread64:error=EIO:when=$n" list > out 2> err && break
  one_line err 'a.db: disk I/O error: call again: nothing is lost'
  faults=$((faults + 1))
done
[ "$faults" -ge 9 ] || fail "$faults calls that read: this sees too few"
expect 1 failing a.db pread64:error=EIO:when=4+ list
one_line err 'a.db: disk I/O error: call again: nothing is lost'
expect 0 "$roomgraph" archive a.db list

# What is damaged itself is told so.
{ head -c 4096 a.db; head -c 400 /dev/zero; tail -c +4497 a.db; } > torn.db
expect 1 "$roomgraph" archive torn.db list
one_line err 'torn.db: database disk image is malformed: bring back a copy of it'
