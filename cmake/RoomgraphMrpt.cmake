# The only place that knows how MRPT's versions call their packages: MRPT 2 has mrpt-maps with the
# target mrpt::maps, MRPT 3 has mrpt_maps with mrpt::mrpt_maps, and moved scenes from opengl to viz.
# One program takes all parts from one of them: ROOMGRAPH_MRPT, or else MRPT 2 where it is there.
set(ROOMGRAPH_MRPT "" CACHE STRING "The MRPT to build with: 2 or 3; empty for 2 where it is there")
set_property(CACHE ROOMGRAPH_MRPT PROPERTY STRINGS "" 2 3)

# roomgraph_find_mrpt(PART): one of MRPT 3's parts, as maps or viz. Sets roomgraph_mrpt_PART to its
# target; it is empty where there is none.
macro(roomgraph_find_mrpt part)
  if(NOT roomgraph_mrpt_major)
    roomgraph_choose_mrpt()
  endif()
  if(roomgraph_mrpt_major EQUAL 2)
    string(REPLACE viz opengl roomgraph_mrpt_name mrpt-${part})
    string(REPLACE mrpt- mrpt:: roomgraph_mrpt_${part} ${roomgraph_mrpt_name})
  else()
    set(roomgraph_mrpt_name mrpt_${part})
    set(roomgraph_mrpt_${part} mrpt::${roomgraph_mrpt_name})
  endif()
  find_package(${roomgraph_mrpt_name} QUIET)
  if(NOT ${roomgraph_mrpt_name}_FOUND)
    set(roomgraph_mrpt_${part})
  endif()
endmacro()

# Sets roomgraph_mrpt_major to 2 or 3.
macro(roomgraph_choose_mrpt)
  if(NOT "${ROOMGRAPH_MRPT}" MATCHES "^[23]?$")
    message(FATAL_ERROR "ROOMGRAPH_MRPT is '${ROOMGRAPH_MRPT}': set it to 2 or 3, or leave it out")
  endif()
  set(roomgraph_mrpt_major ${ROOMGRAPH_MRPT})
  if(NOT roomgraph_mrpt_major)
    find_package(mrpt-maps QUIET)
    set(roomgraph_mrpt_major 3)
    if(mrpt-maps_FOUND)
      set(roomgraph_mrpt_major 2)
    endif()
  endif()
  message(STATUS "All parts of MRPT are taken from MRPT ${roomgraph_mrpt_major} (see ROOMGRAPH_MRPT)")
endmacro()

# The same as roomgraph_find_mrpt, and an error where there is none.
macro(roomgraph_need_mrpt part)
  roomgraph_find_mrpt(${part})
  if(NOT roomgraph_mrpt_${part})
    message(FATAL_ERROR "There is no package ${roomgraph_mrpt_name} of MRPT ${roomgraph_mrpt_major}: "
      "install it (Debian has MRPT 2's as libmrpt-*-dev), or choose the other "
      "version with -DROOMGRAPH_MRPT=2 or 3")
  endif()
endmacro()
