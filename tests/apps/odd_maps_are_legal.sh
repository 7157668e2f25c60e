# A map without anything in it gives a valid, empty graph and a note, and no error.
. "$(dirname "$0")/common.sh"
plain free.pgm 376
plain occupied.pgm 000
plain unknown.pgm 315
printf 'P5\n1 1\n255\n\376' > tiny.pgm
for preset in default paper; do
  for map in free occupied unknown tiny; do
    expect 0 "$roomgraph" extract $map.pgm -o o --preset $preset
    grep -q "note" err || fail "$map: no note on stderr"
    expect 0 "$roomgraph" info o/$map.json o/$map.roomgraph
  done
done
rooms closed.pgm 82
expect 0 "$roomgraph" extract closed.pgm -o o
head -1 out > first
one_line first "1 room, 1 vertex, 0 edges"
