# The only place that knows how MRPT's versions call their packages: MRPT 2 has mrpt-maps with the
# target mrpt::maps, MRPT 3 has mrpt_maps with mrpt::mrpt_maps, and moved scenes from opengl to viz.

# roomgraph_find_mrpt(PART): one of MRPT 3's parts, as maps or viz. Sets roomgraph_mrpt_PART to its
# target; it is empty where there is none.
macro(roomgraph_find_mrpt part)
  string(REPLACE viz opengl roomgraph_mrpt_old ${part})
  find_package(mrpt-${roomgraph_mrpt_old} QUIET)
  set(roomgraph_mrpt_${part})
  if(mrpt-${roomgraph_mrpt_old}_FOUND)
    set(roomgraph_mrpt_${part} mrpt::${roomgraph_mrpt_old})
  else()
    find_package(mrpt_${part} QUIET)
    if(mrpt_${part}_FOUND)
      set(roomgraph_mrpt_${part} mrpt::mrpt_${part})
    endif()
  endif()
endmacro()

# The same, and an error where there is none.
macro(roomgraph_need_mrpt part)
  roomgraph_find_mrpt(${part})
  if(NOT roomgraph_mrpt_${part})
    message(FATAL_ERROR "There is no MRPT: neither a package mrpt-${roomgraph_mrpt_old} (MRPT 2, "
      "libmrpt-${roomgraph_mrpt_old}-dev on Debian) nor mrpt_${part} (MRPT 3) is found")
  endif()
endmacro()
