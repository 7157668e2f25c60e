# A run that was stopped goes on where it was, with the same bytes in the end.
. "$(dirname "$0")/common.sh"
rooms a.pgm
few="--distances 1,5 --percents 2,14 --repeats 20"
expect 0 "$roomgraph" stability a.pgm $few -o whole

# Stopped, as soon as something is saved, without a chance to tidy up.
"$roomgraph" stability a.pgm $few -o stopped --threads 1 > /dev/null &
while [ ! -e stopped/a.stability.partial.json ] && kill -0 $! 2> /dev/null; do sleep 0.01; done
kill -9 $! 2> /dev/null || true
wait $! 2> /dev/null || true
if [ -e stopped/a.stability.partial.json ]; then cp stopped/a.stability.partial.json saved; fi
expect 0 "$roomgraph" stability a.pgm $few -o stopped
diff -r whole stopped
[ -e saved ] || { echo "ended before it could be stopped"; exit 0; }

# What is saved is not computed again: a wrong number in it comes out.
mkdir wrong other
sed 's/"rooms":[0-9]*/"rooms":99/' saved > wrong/a.stability.partial.json
expect 0 "$roomgraph" stability a.pgm $few -o wrong
grep -q '"rooms":99}' wrong/a.stability.json || fail "what was saved is computed again"

# That of another seed, or a damaged one, does not count.
sed 's/"rooms":[0-9]*/"rooms":99/' saved > other/a.stability.partial.json
expect 0 "$roomgraph" stability a.pgm $few -o other --seed 2
if grep -q '"rooms":99}' other/a.stability.json; then fail "taken from another seed"; fi
head -c 500 saved > other/a.stability.partial.json
expect 0 "$roomgraph" stability a.pgm $few -o other
diff -r whole other
