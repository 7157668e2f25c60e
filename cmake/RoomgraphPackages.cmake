# Debian packages, by cpack: roomgraph (the program), roomgraph-view (the window, where there is
# mrpt-gui), roomgraph-mrpt (the library that MRPT's programs
# load) and libroomgraph-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the roomgraph developers" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program mrpt dev)
if(TARGET roomgraph_view)
  list(APPEND CPACK_COMPONENTS_ALL view)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME roomgraph)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "rooms and paths of 2D grid maps
 Extracts topology graphs with rooms from maps of MRPT, ROS and from pictures,
 and compares several maps of one building.")
# Leaflet and D3 are part of the program; the fonts of its pictures are not.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)

set(CPACK_DEBIAN_VIEW_PACKAGE_NAME roomgraph-view)
set(CPACK_DEBIAN_VIEW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_VIEW_DESCRIPTION "window on maps, runs and comparisons of roomgraph
 Shows a map with its graph, a run with its path and scans, and several runs
 laid on each other, with the places where they break.")

set(CPACK_DEBIAN_MRPT_PACKAGE_NAME roomgraph-mrpt)
set(CPACK_DEBIAN_MRPT_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MRPT_DESCRIPTION "room graphs for the programs of MRPT
 The class CRoomGraph, for RawLogViewer and SceneViewer3D (-l libroomgraph_mrpt.so).")

# What a program that links the static libraries needs, see roomgraph-config.cmake.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libroomgraph-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "roomgraph-mrpt (= ${PROJECT_VERSION}), libmrpt-maps-dev, libmrpt-opengl-dev, libboost-dev, \
libceres-dev, libcgal-dev, libeigen3-dev, libcairo2-dev, libjpeg-dev, libpng-dev, libsqlite3-dev, \
libssl-dev, libglu1-mesa-dev, libyaml-cpp-dev, libzstd-dev, nlohmann-json3-dev, zlib1g-dev, pkg-config")
set(CPACK_DEBIAN_DEV_DESCRIPTION "rooms and paths of 2D grid maps - development files
 Headers, static libraries and CMake's configuration of roomgraph.")

# The licences of all that is in them, as Debian looks for them.
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" own_licence)
file(READ "${PROJECT_SOURCE_DIR}/libs/page/src/embedded/licences.txt" embedded_licences)
file(WRITE "${PROJECT_BINARY_DIR}/copyright" "${own_licence}\n${embedded_licences}")
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} component)
  string(TOLOWER ${component} name)
  install(FILES "${PROJECT_BINARY_DIR}/copyright" COMPONENT ${name}
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${component}_PACKAGE_NAME}")
endforeach()
include(CPack)
