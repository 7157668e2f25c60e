# Killed, or with a full disk, at any system call that writes, a call leaves each result as it was or
# whole and new; the next call makes all of them. With little memory it ends with a line.
. "$(dirname "$0")/common.sh"
command -v strace > /dev/null || { echo "skipped: strace is not here"; exit 77; }
strace -o /dev/null true 2> /dev/null || { echo "skipped: strace may not trace here"; exit 77; }
rooms room.pgm
extract() { "$@" "$roomgraph" extract room.pgm --resolution 0.05 --format json,graphml,geojson --threads 1 -q -o "$PWD/now" "${more[@]}"; }
more=() && extract env && mv now old
more=(--preset paper) && extract env && mv now new
for file in old/*; do ! cmp -s "$file" "new/${file#old/}" || fail "$file is the same in both"; done

formats=(json graphml geojson)
# Of the calls that write only those to the results count, and not the lines on stderr.
paths=(-P "$PWD/now")
for format in "${formats[@]}"; do
  for name in "now/room.$format" "now/room.$format.roomgraph-part0"; do
    paths+=(-P "$PWD/$name")
  done
done

# stopped HOW CALL N: the Nth system call of that name stopped; whether there was one.
stopped() {
  rm -rf now && cp -r old now
  local code=0
  extract strace -f -o trace "${paths[@]}" \
    -e "inject=$2:$1:when=$3" "${also[@]}" > out 2> err || code=$?
  for file in now/room.*; do
    case $file in *.roomgraph-part*) continue ;; esac
    cmp -s "$file" "old/${file#now/}" || cmp -s "$file" "new/${file#now/}" ||
      fail "$file is neither old nor new after $2 $3 ($1)"
  done
  grep -v '^strace: ' err > said || true
  [ "$code" -ne 0 ]
}
kills=0 full=0 also=()
for call in openat write fsync rename renameat2; do
  for ((n = 1; ; ++n)); do
    stopped signal=KILL $call $n || break
    kills=$((kills + 1))
    extract env
    [ "$(ls now)" = "$(ls new)" ] || { ls now; fail "$call $n leaves something behind"; }
    for file in new/*; do cmp "$file" "now/${file#new/}"; done
  done
  # What cannot be exchanged is renamed; here neither can be.
  [ $call != renameat2 ] || also=(-e inject=rename:error=ENOSPC)
  for ((n = 1; ; ++n)); do
    stopped error=ENOSPC $call $n || break
    full=$((full + 1))
    one_line said roomgraph:
    [ "$(ls now)" = "$(ls old)" ] || { ls now; fail "a full disk at $call $n leaves something behind"; }
    for file in old/*; do cmp "$file" "now/${file#old/}"; done
  done
done
[ "$kills" -ge 9 ] && [ "$full" -ge 9 ] || fail "$kills and $full calls that write: this sees too few"

# A larger map, which does not fit into what is enough to start.
{ printf 'P5\n3000 2000\n255\n'; head -c 6000000 /dev/zero | tr '\000' '\377'; } > large.pgm
short=0 whole=0
for megabytes in 60 100 150 200 244 250 275 300 325 350 375 400 450 500 2000; do
  code=0
  (ulimit -v $((megabytes * 1024)) &&
    "$roomgraph" extract large.pgm --resolution 0.05 --format json -q -o memory > out 2> err) || code=$?
  case $code in
    0) whole=1 ;;
    1) one_line err memory && short=$((short + 1)) ;;
    127) ;;  # not even its libraries fit in
    *) cat err; fail "exit code $code with $megabytes MB" ;;
  esac
done
[ "$short" -ge 1 ] && [ "$whole" -eq 1 ] || fail "this sees no want of memory"
echo "$kills kills, $full full disks, $short times short of memory"
