# Debian packages, by cpack: roomgraph (the program), roomgraph-view (the window, where there is
# mrpt-gui), roomgraph-mrpt (the library that MRPT's programs load), libroomgraph-dev and, where
# there is pybind11, python3-roomgraph.
set(CPACK_GENERATOR DEB)
# Who builds them answers for them: as Debian's tools have it, DEBFULLNAME and DEBEMAIL.
set(packager "$ENV{DEBFULLNAME}")
if(NOT packager)
  set(packager "the roomgraph developers")
endif()
if(DEFINED ENV{DEBEMAIL})
  string(APPEND packager " <$ENV{DEBEMAIL}>")
endif()
set(CPACK_PACKAGE_CONTACT "${packager}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program mrpt dev)
if(TARGET roomgraph_view)
  list(APPEND CPACK_COMPONENTS_ALL view)
endif()
if(TARGET roomgraph_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

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
 The classes CRoomGraph and CMapComparison, for RawLogViewer and
 SceneViewer3D (-l libroomgraph_mrpt.so).")
file(WRITE "${PROJECT_BINARY_DIR}/debian/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_MRPT_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/debian/triggers")
set(CPACK_DEBIAN_MRPT_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)

# An extension module is of one minor version of Python.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-roomgraph)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(TARGET roomgraph_python)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy, fonts-dejavu-core")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-networkx, python3-pandas")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "rooms and paths of 2D grid maps - Python module
 Extracts topology graphs with rooms from maps of MRPT, ROS and from pictures
 or arrays, compares several maps of one building, and mends them.")

# What a program that links the static libraries needs, see roomgraph-config.cmake.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libroomgraph-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "roomgraph-mrpt (= ${PROJECT_VERSION}), libmrpt-maps-dev, libmrpt-opengl-dev, libboost-dev, \
libceres-dev, libcgal-dev, libeigen3-dev, libcairo2-dev, libexpat1-dev, libjpeg-dev, libpng-dev, libsqlite3-dev, \
libssl-dev, libglu1-mesa-dev, libyaml-cpp-dev, libzstd-dev, nlohmann-json3-dev, zlib1g-dev, pkg-config")
set(CPACK_DEBIAN_DEV_DESCRIPTION "rooms and paths of 2D grid maps - development files
 Headers, static libraries and CMake's configuration of roomgraph.")

# The licences of all that is in them, and what is new, as Debian looks for them.
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" own_licence)
file(READ "${PROJECT_SOURCE_DIR}/libs/page/src/embedded/licences.txt" embedded_licences)
file(WRITE "${PROJECT_BINARY_DIR}/copyright" "${own_licence}\n${embedded_licences}")
# What is compiled into the program, as Debian tells of it.
foreach(package libcli11-dev nlohmann-json3-dev libkainjow-mustache-dev libceres-dev
    pybind11-dev)
  if(EXISTS "/usr/share/doc/${package}/copyright")
    file(READ "/usr/share/doc/${package}/copyright" licence)
    file(APPEND "${PROJECT_BINARY_DIR}/copyright" "\nOf ${package}, parts of which are compiled in:\n\n${licence}")
  endif()
endforeach()
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where it is set
file(WRITE "${PROJECT_BINARY_DIR}/debian/changelog" "\
roomgraph (${PROJECT_VERSION}) bookworm; urgency=medium

  * /usr/share/doc/roomgraph/CHANGELOG.md tells what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
execute_process(COMMAND "${ROOMGRAPH_GZIP}" -9 -n -f "${PROJECT_BINARY_DIR}/debian/changelog")
# A wheel has its licences in a folder of its own.
if(SKBUILD)
  install(FILES "${PROJECT_BINARY_DIR}/copyright" COMPONENT python
    DESTINATION "${SKBUILD_METADATA_DIR}/licenses")
  return()
endif()
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} component)
  string(TOLOWER ${component} name)
  install(FILES "${PROJECT_BINARY_DIR}/copyright" "${PROJECT_BINARY_DIR}/debian/changelog.gz"
    COMPONENT ${name} OPTIONAL
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${component}_PACKAGE_NAME}")
endforeach()
include(CPack)
