# Sets ROOMGRAPH_BUILD_PYTHON, and finds what the Python package is built with. By default it is
# built where pybind11 is there, unless roomgraph is part of another project, or sanitized: then
# Python itself would have to be.
if(PROJECT_IS_TOP_LEVEL AND NOT ROOMGRAPH_SANITIZE OR ROOMGRAPH_BUILD_PYTHON)
  # The Python of the system, for which it has pybind11, rather than another one in the PATH; pip
  # says which is its own.
  if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python 3.7 QUIET COMPONENTS Interpreter Development.Module)
  if(Python_FOUND)
    find_package(pybind11 2.9 QUIET CONFIG)
  endif()
endif()
set(builds_python OFF)
if(pybind11_FOUND)
  set(builds_python ON)
endif()
option(ROOMGRAPH_BUILD_PYTHON "Build the Python package" ${builds_python})
if(ROOMGRAPH_BUILD_PYTHON AND NOT pybind11_FOUND)
  message(FATAL_ERROR "There is no Python to build for, or no pybind11: install them (Debian has "
    "python3-dev and pybind11-dev), or set ROOMGRAPH_BUILD_PYTHON to OFF")
endif()
