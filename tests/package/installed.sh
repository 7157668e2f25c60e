#!/bin/bash
# installed.sh BUILD_DIR WORK_DIR: a stranger builds against what `cmake --install` gives.
set -euo pipefail
build=$1 work=$2 stranger=$(cd "$(dirname "$0")/stranger" && pwd)
rm -rf "$work"
cmake --install "$build" --prefix "$work/prefix" > /dev/null
test -x "$work/prefix/bin/roomgraph"
test -f "$work/prefix/share/roomgraph/config_files/default.ini"

# Each link of the pages leads to what is installed with them.
(cd "$work/prefix/share/doc/roomgraph" && find . -name '*.md' | while read -r page; do
  { grep -oP '\]\(\K[^):#\s]+(?=[)#])' "$page" || true; } | while read -r link; do
    [ -e "$(dirname "$page")/$link" ] || echo "$page: $link leads nowhere"
  done
done) > "$work/lost"
[ ! -s "$work/lost" ] || { cat "$work/lost"; exit 1; }

cmake -S "$stranger" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/configured" 2>&1 ||
  { cat "$work/configured"; exit 1; }
# No type of build is set, of which CGAL would say a dozen lines.
if grep -A12 'CGAL performance notice' "$work/configured"; then exit 1; fi
cmake --build "$work/build"
"$work/build/stranger"
"$work/build/stranger_plugin"

# The same without CMake.
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name roomgraph.pc)")
[ "$(pkg-config --modversion roomgraph)" = "$("$work/prefix/bin/roomgraph" --version)" ]
for program in stranger stranger_plugin; do
  # shellcheck disable=SC2046
  "${CXX:-c++}" -O0 "$stranger/$program.cpp" -o "$work/$program" $(pkg-config --cflags --libs roomgraph)
  "$work/$program"
done
