#!/bin/bash
# subdirectory.sh SOURCE_DIR WORK_DIR: a stranger builds roomgraph as a part of his own project.
set -euo pipefail
source=$1 work=$2 stranger=$(cd "$(dirname "$0")/stranger" && pwd)
rm -rf "$work"
cmake -S "$stranger" -B "$work" -DROOMGRAPH_SUBDIRECTORY="$source" -DCMAKE_CXX_FLAGS=-O0
cmake --build "$work" --target stranger --parallel 2
"$work/stranger"
# Nothing that the stranger did not ask for.
if grep 'GTest_DIR\|CLI11_DIR' "$work/CMakeCache.txt"; then exit 1; fi
