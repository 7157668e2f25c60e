# Helpers that every lib, app and test of the tree is declared with.

# Options common to all targets: C++17, warnings, sanitizers.
function(roomgraph_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # A library that serves several programs must give the same numbers in each:
  # fused multiply-add would round differently from one machine to the next.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wpedantic -ffp-contract=off)
  if(ROOMGRAPH_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(ROOMGRAPH_SANITIZE)
    # AddressSanitizer finds null pointers and objects that are too small as well; to look at each
    # pointer for these and its alignment again would nearly double the time to compile.
    target_compile_options(${target} PRIVATE -fsanitize=${ROOMGRAPH_SANITIZE}
      -fno-sanitize=null,vptr,object-size,alignment -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${ROOMGRAPH_SANITIZE})
    # Eigen's functions in Ceres' library, which no sanitizer compiled, and ours are linked as one:
    # they must allocate alike, while Eigen chooses another way where AddressSanitizer is on.
    target_compile_definitions(${target} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif()
endfunction()

# roomgraph_add_library(NAME SOURCES file... [DEPENDS lib...] [PRIVATE_DEPENDS lib...])
# One stage of the pipeline: target roomgraph_NAME, alias roomgraph::NAME.
# A stage sees the headers of its DEPENDS only, so the include rule is the link line.
function(roomgraph_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target roomgraph_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(roomgraph::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    # What only the libraries and programs of this tree include; it is not installed.
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/internal>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  roomgraph_compile_options(${target})
  if(ROOMGRAPH_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Wconversion)
  endif()
  install(TARGETS ${target} EXPORT roomgraph ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    COMPONENT dev)
  if(IS_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include")
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  endif()
endfunction()

# roomgraph_add_test(LIB STEP... ) builds tests/LIB/STEP_unittest.cpp, one program per lib.
function(roomgraph_add_test lib)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  set(target test_${lib})
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE roomgraph::${lib} ${ARG_DEPENDS} GTest::gtest_main)
  # A test also sees what its library keeps to itself.
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/libs/${lib}/src")
  roomgraph_compile_options(${target})
  # To read what they include takes longer than to compile them: eight are read as one source.
  if(NOT ROOMGRAPH_WARNINGS_AS_ERRORS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
  if(ROOMGRAPH_SANITIZE MATCHES address)
    # Such a program takes longer to start than most tests do to run: it is started once.
    add_test(NAME ${target} COMMAND ${target})
    set_tests_properties(${target} PROPERTIES LABELS ${lib})
  else()
    gtest_discover_tests(${target} PROPERTIES LABELS ${lib} DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
