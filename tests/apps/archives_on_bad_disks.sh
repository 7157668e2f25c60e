# A disk that fails to read is no damage of an archive; one that is full keeps nobody from reading.
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
for n in {1..15}; do
  failing a.db "pread64:error=EIO:when=$n" list > out 2> err && continue
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

# SQLite makes a file beside the archive before it reads.
full() { failing a.db-shm pwrite64:error=ENOSPC "$@"; }
for what in list report rooms export; do
  "$roomgraph" archive a.db $what > whole
  expect 0 full $what
  cmp out whole
done
rooms b.pgm 164
cp a.db before.db
for what in 'rename robot walter' 'add b.pgm --resolution 0.05'; do
  # shellcheck disable=SC2086
  expect 1 full $what
  grep -q 'database or disk is full: free some space, then call again: nothing is lost' err ||
    { cat err; fail "$what does not tell that the disk is full"; }
done
cmp a.db before.db
expect 0 "$roomgraph" archive a.db rename robot walter
