# The same files whatever the number of threads, and none of the unfinished ones left.
. "$(dirname "$0")/common.sh"
rooms a.pgm
few="--distances 1,5 --percents 2,14 --repeats 2"
expect 0 "$roomgraph" stability a.pgm $few -o one --threads 1
sed 's#one/##' out > out1
expect 0 "$roomgraph" stability a.pgm $few -o many --threads 8
sed 's#many/##' out > out8
diff -r one many
cmp out1 out8
[ "$(ls one)" = $'a.stability.csv\na.stability.json' ] || fail "other files: $(ls one)"
[ "$(wc -l < one/a.stability.csv)" -eq 5 ] || fail "not a line for each row"
head -1 one/a.stability.csv | grep -q '^distance_px,percent,room,no_room,ratio_percent,' ||
  fail "not the columns of the paper"
grep -q 'labelled 1 to 4' out || fail "the paper's two sets of distances are not told"

expect 0 "$roomgraph" stability a.pgm $few -o other --seed 8
if cmp -s one/a.stability.csv other/a.stability.csv; then fail "the seed changes nothing"; fi

# What makes no sense.
expect 2 "$roomgraph" stability a.pgm --percents 2,101
one_line err percents 101
expect 2 "$roomgraph" stability a.pgm --distances 1,x
expect 2 "$roomgraph" stability a.pgm --repeats 0
one_line err repeats
expect 1 "$roomgraph" stability missing.pgm
one_line err missing.pgm
