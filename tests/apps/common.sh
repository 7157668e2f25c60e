# What the tests of the program share: . common.sh, at the top of each.
set -euo pipefail
roomgraph=$1 source_dir=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() { echo "FAILED: $*" >&2; exit 1; }

# expect CODE COMMAND...: runs it, with its output in the files out and err.
expect() {
  local code=$1 got=0
  shift
  "$@" > out 2> err || got=$?
  [ "$got" -eq "$code" ] || { cat out err >&2; fail "exit code $got, not $code: $*"; }
}

# one_line FILE TEXT...: the file is one line that holds each text.
one_line() {
  local file=$1 text
  shift
  [ "$(wc -l < "$file")" -eq 1 ] || { cat "$file" >&2; fail "$file is not one line"; }
  for text in "$@"; do
    grep -qF -- "$text" "$file" || { cat "$file" >&2; fail "$file does not say '$text'"; }
  done
}

# rooms FILE [WIDTH [DRIVE]]: a picture (PGM) of two rooms of 4 m each with a door, WIDTH cells wide or 162; a number of a
# drive draws the walls as rough as that drive has found them.
rooms() {
  local width=${2-162} height=82
  { printf 'P5\n%d %d\n255\n' "$width" "$height"
    awk -v w="$width" -v h="$height" -v drive="${3-}" 'BEGIN {
      srand(drive)
      for (i = 0; i < w + h; ++i) for (k = 0; k < 4; ++k) rough[i, k] = drive == "" ? 0 : int(4 * rand())
      for (y = 0; y < h; ++y) for (x = 0; x < w; ++x) {
        outer = x < 2 + rough[y, 0] || y < 2 + rough[x, 1] ||
          x >= w - 2 - rough[y, 2] || y >= h - 2 - rough[x, 3]
        middle = x >= 80 - rough[h + y, 0] && x < 82 + rough[h + y, 1] && !(y > 30 && y < 50)
        printf "%s", outer || middle ? "#" : "~"
      } }' | tr '#~' '\000\377'
  } > "$1"
}

# plain FILE GREY(octal): a picture of one grey.
plain() {
  { printf 'P5\n40 30\n255\n'
    head -c 1200 /dev/zero | tr '\000' "\\$2"
  } > "$1"
}
