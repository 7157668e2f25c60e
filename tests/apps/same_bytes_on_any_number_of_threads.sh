# The same results, and messages in the order of the arguments, on one thread and on many.
. "$(dirname "$0")/common.sh"
maps=()
for i in 1 2 3 4 5 6 7 8; do
  rooms map$i.pgm $((90 + 10 * i))
  maps+=(map$i.pgm)
done
expect 0 "$roomgraph" extract "${maps[@]}" -o one --threads 1
sed 's#one/##' out > out1
expect 0 "$roomgraph" extract "${maps[@]}" -o many --threads 8
sed 's#many/##' out > out8
diff -r one many
cmp out1 out8
[ "$(ls one | wc -l)" -eq 56 ] || fail "not seven files for each map: $(ls one)"
