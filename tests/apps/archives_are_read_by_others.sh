# An archive that may be read but not written can be listed; one of no bytes is none.
. "$(dirname "$0")/common.sh"
[ "$(id -u)" -eq 0 ] || { echo "skipped: only root can call the program as somebody else"; exit 77; }
rooms a.pgm
rooms b.pgm 164
expect 0 "$roomgraph" archive a.db add a.pgm --resolution 0.05
chmod 711 "$work"
mkdir -m 755 shelf 'odd?%41 #'
install -m 644 a.db shelf/a.db
install -m 644 a.db 'odd?%41 #/a.db'
# as_reader COMMAND...: as somebody who may write nothing here.
as_reader() { setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; }
as_reader test -x "$roomgraph" || { echo "skipped: others may not call the program where it lies"; exit 77; }
for archive in shelf/a.db 'odd?%41 #/a.db'; do
  expect 0 as_reader "$roomgraph" archive "$archive" list
  grep -q a.pgm out || fail "the run is not listed"
  for what in rooms report 'export --format prometheus'; do
    # shellcheck disable=SC2086
    expect 0 as_reader "$roomgraph" archive "$archive" $what
  done
  expect 1 as_reader "$roomgraph" archive "$archive" name R0 Kitchen
  one_line err "$archive"
  expect 1 as_reader "$roomgraph" archive "$archive" add b.pgm --resolution 0.05
  grep -qF "$archive" err || { cat err; fail "does not name the archive"; }
done
[ "$(ls shelf)" = a.db ] || fail "reading has left files"
# While another program is writing, its log is read, too.
sqlite3 shelf/a.db "PRAGMA journal_mode=WAL; PRAGMA wal_autocheckpoint=0; UPDATE run SET robot='walter'" \
  ".shell setpriv --reuid=65534 --regid=65534 --clear-groups '$roomgraph' archive shelf/a.db list > seen" > /dev/null
grep -q walter seen || { cat seen; fail "what is in the log is not read"; }

: > empty.db
for what in list rooms 'report --fail-on-alarm' export 'add a.pgm --resolution 0.05'; do
  # shellcheck disable=SC2086
  expect 1 "$roomgraph" archive empty.db $what
  one_line err "empty.db: is empty"
done
[ ! -s empty.db ] || fail "an archive was made of nothing"
expect 2 "$roomgraph" archive a.db add a.pgm --robot ''
one_line err "--robot"
