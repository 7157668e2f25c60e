# cmake/RoomgraphMrpt.cmake takes all parts from one MRPT, with packages that only look like MRPT's.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { cat "$work/out" >&2; echo "FAILED: $*" >&2; exit 1; }

# package FOLDER NAME...
package() {
  local folder=$work/$1 name
  shift
  for name; do mkdir -p "$folder/$name"; : > "$folder/$name/$name-config.cmake"; done
}
package two mrpt-maps mrpt-opengl
package three mrpt_maps mrpt_viz mrpt_gui
mkdir "$work/project"
cat > "$work/project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.22)
project(chosen LANGUAGES NONE)
list(APPEND CMAKE_MODULE_PATH "$1/cmake")
include(RoomgraphMrpt)
roomgraph_need_mrpt(maps)
roomgraph_need_mrpt(viz)
roomgraph_find_mrpt(gui)
message(STATUS "takes \${roomgraph_mrpt_maps} \${roomgraph_mrpt_viz} '\${roomgraph_mrpt_gui}'")
END
# takes EXPECTED PREFIXES [OPTION]: what is taken where these folders have packages
takes() {
  rm -rf "$work/build"
  cmake -S "$work/project" -B "$work/build" -DCMAKE_MAKE_PROGRAM=true -DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF \
    -DCMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH=OFF -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF \
    -DCMAKE_PREFIX_PATH="$2" "${@:3}" > "$work/out" 2>&1 || true
  grep -qF -- "$1" "$work/out" || fail "no '$1' with $*"
}
both="$work/two;$work/three"
takes "takes mrpt::maps mrpt::opengl ''" "$both"
takes "takes mrpt::mrpt_maps mrpt::mrpt_viz 'mrpt::mrpt_gui'" "$both" -DROOMGRAPH_MRPT=3
takes "takes mrpt::mrpt_maps mrpt::mrpt_viz 'mrpt::mrpt_gui'" "$work/three"
takes "There is no package mrpt-maps of MRPT 2" "$work/three" -DROOMGRAPH_MRPT=2
takes "There is no package mrpt_maps of MRPT 3" "$work/none"
takes "set it to 2 or 3" "$both" -DROOMGRAPH_MRPT=4
