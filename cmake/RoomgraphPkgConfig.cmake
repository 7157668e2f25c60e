# roomgraph.pc, for projects that are not built by CMake. The libraries are static, so it names all
# that they need: what CMake links to roomgraph::roomgraph.
#   g++ my_program.cpp $(pkg-config --cflags --libs roomgraph)

# The targets of the libraries' own folders are not seen from here.
include("${CMAKE_CURRENT_LIST_DIR}/roomgraph-dependencies.cmake")

# Adds the words that link and include ITEM, a target or a library, to the lists roomgraph_pc_own
# (names), roomgraph_pc_libs and roomgraph_pc_cflags (flags) of the caller. What is only linked
# (IS_LINKED_ONLY), as are the libraries behind it, needs no headers.
function(roomgraph_collect_flags item is_linked_only)
  if(item MATCHES "^\\$<LINK_ONLY:(.*)>$")
    set(item "${CMAKE_MATCH_1}")
    set(is_linked_only TRUE)
  endif()
  if(item MATCHES "\\$<" OR "${item} FALSE" IN_LIST roomgraph_pc_seen
      OR "${item} ${is_linked_only}" IN_LIST roomgraph_pc_seen)
    return()  # $<BUILD_INTERFACE:...> is no part of what is installed
  endif()
  list(APPEND roomgraph_pc_seen "${item} ${is_linked_only}")
  set(libs "")
  if(NOT TARGET ${item})
    roomgraph_link_flags(libs "${item}")
  else()
    get_target_property(aliased ${item} ALIASED_TARGET)
    if(aliased)
      set(item ${aliased})
    endif()
    get_target_property(is_imported ${item} IMPORTED)
    get_target_property(type ${item} TYPE)
    if(type STREQUAL "SHARED_LIBRARY" AND NOT is_imported)
      return()  # what MRPT's programs load
    elseif(NOT type STREQUAL "INTERFACE_LIBRARY" AND is_imported)
      get_target_property(location ${item} LOCATION)
      roomgraph_link_flags(libs "${location}")
    elseif(NOT type STREQUAL "INTERFACE_LIBRARY")
      list(APPEND roomgraph_pc_own ${item})
    endif()
    get_target_property(folders ${item} INTERFACE_INCLUDE_DIRECTORIES)
    foreach(folder IN LISTS folders)
      if(is_imported AND NOT is_linked_only AND IS_ABSOLUTE "${folder}"
          AND NOT folder IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
        list(APPEND roomgraph_pc_cflags "-I${folder}")
      endif()
    endforeach()
  endif()
  list(APPEND roomgraph_pc_libs ${libs})
  if(TARGET ${item})
    get_target_property(more ${item} INTERFACE_LINK_LIBRARIES)
    foreach(next IN LISTS more)
      if(next)
        roomgraph_collect_flags("${next}" ${is_linked_only})
      endif()
    endforeach()
  endif()
  foreach(list seen own libs cflags)
    set(roomgraph_pc_${list} "${roomgraph_pc_${list}}" PARENT_SCOPE)
  endforeach()
endfunction()

# How a linker is told of a library: -lNAME, with its folder where that is not searched anyway.
function(roomgraph_link_flags out library)
  set(flags "")
  if(library MATCHES "^(.*)/lib([^/]+)\\.(so[.0-9]*|a)$")
    set(flags "-l${CMAKE_MATCH_2}")
    if(NOT CMAKE_MATCH_1 IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
      list(PREPEND flags "-L${CMAKE_MATCH_1}")
    endif()
  elseif(library MATCHES "^-")
    set(flags "${library}")
  elseif(NOT library MATCHES "/")
    set(flags "-l${library}")
  endif()
  set(${out} "${flags}" PARENT_SCOPE)
endfunction()

set(roomgraph_pc_seen "")
set(roomgraph_pc_own "")
set(roomgraph_pc_libs "")
set(roomgraph_pc_cflags "")
roomgraph_collect_flags(roomgraph::roomgraph FALSE)
list(REMOVE_DUPLICATES roomgraph_pc_own)
# The libraries refer to each other, so they form a group; of the others, each stands behind those
# that need it.
list(TRANSFORM roomgraph_pc_own PREPEND "-l")
list(JOIN roomgraph_pc_own " " roomgraph_pc_own)
list(REVERSE roomgraph_pc_libs)
list(REMOVE_DUPLICATES roomgraph_pc_libs)
list(REVERSE roomgraph_pc_libs)
list(JOIN roomgraph_pc_libs " " roomgraph_pc_libs)
list(REMOVE_DUPLICATES roomgraph_pc_cflags)
list(JOIN roomgraph_pc_cflags " " roomgraph_pc_cflags)
file(RELATIVE_PATH roomgraph_pc_prefix "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
file(WRITE "${PROJECT_BINARY_DIR}/roomgraph.pc" "\
prefix=\${pcfiledir}/${roomgraph_pc_prefix}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: roomgraph
Description: ${PROJECT_DESCRIPTION}
Version: ${PROJECT_VERSION}
Cflags: -I\${includedir} ${roomgraph_pc_cflags}
Libs: -L\${libdir} -Wl,--start-group ${roomgraph_pc_own} -Wl,--end-group ${roomgraph_pc_libs}
")
install(FILES "${PROJECT_BINARY_DIR}/roomgraph.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT dev)
