#!/bin/bash
# licences.sh SOURCE_DIR COMPILER: no file of the libraries and programs includes, not even by way of
# other headers, a part of CGAL that is under the GPL. Those parts include CGAL/license/*.h
# (other than lgpl.h).
set -euo pipefail
source=$1 compiler=$2 users=0
cd "$source"
includes=()
for folder in libs/*/include libs/*/src; do includes+=("-I$folder"); done

while read -r file; do
  users=$((users + 1))
  found=$("$compiler" -std=c++17 -M "${includes[@]}" "$file" | tr ' ' '\n' |
    grep '/CGAL/license/' | grep -v '/lgpl.h' || true)
  [ -z "$found" ] || { echo "$file includes GPL-only CGAL:" $found; exit 1; }
done < <(grep -rlE '#include *[<"]CGAL/' libs apps examples)
[ "$users" -gt 0 ] || { echo "no file includes CGAL: this test looks at nothing"; exit 1; }
# The test itself must be able to find one.
probe=$(echo '#include <CGAL/Delaunay_triangulation_2.h>' | "$compiler" -std=c++17 -x c++ -M -)
[[ $probe == */CGAL/license/Triangulation_2.h* ]] || { echo "this test no longer knows CGAL's GPL parts"; exit 1; }
echo "$users files use CGAL, none of its GPL parts"
