# A call that is told to stop ends by that signal, and leaves no unfinished file.
. "$(dirname "$0")/common.sh"
for i in $(seq 20); do rooms "$i.pgm" $((150 + i)); done
mkdir o
for signal in INT TERM HUP QUIT XCPU; do
  for delay in 0.05 0.15 0.25 0.35 0.45; do
    code=0
    timeout --preserve-status -s $signal "$delay" "$roomgraph" extract ./*.pgm -o o -q || code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq $((128 + $(kill -l $signal))) ] || fail "exit code $code"
    unfinished=$(find o -name '*roomgraph-part*')
    [ -z "$unfinished" ] || fail "$unfinished is left by $signal after $delay s"
  done
done
# What the caller ignores, as nohup does, ends nothing.
for signal in INT HUP; do
  rm -rf o/*
  (trap '' $signal; exec "$roomgraph" extract ./*.pgm -o o -q) &
  sleep 0.2
  kill -s $signal $!
  wait $! || fail "$signal ends a call that ignores it"
  [ "$(find o -name '*.json' | wc -l)" -eq 20 ] || fail "not all is done after an ignored $signal"
done
# A file that may not grow so large is an error that is told, and leaves no part.
rm -rf o/*
code=0
(ulimit -f 4; "$roomgraph" extract 1.pgm -o o -q) 2> err || code=$?
[ "$code" -eq 1 ] || fail "ends with $code where files may not grow"
one_line err "o/"
[ -z "$(ls o)" ] || fail "leaves something where files may not grow"
# All formats of a map, or none.
rm -rf o/*
timeout --preserve-status -s TERM 0.3 "$roomgraph" extract ./*.pgm -o o -q || true
for map in *.pgm; do
  count=$(find o -name "${map%.pgm}.*" | wc -l)
  [ "$count" -eq 0 ] || [ "$count" -eq 7 ] || fail "$count results of $map"
done
