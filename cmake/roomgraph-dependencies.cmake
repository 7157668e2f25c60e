# The packages that programs which link roomgraph need.
include(CMakeFindDependencyMacro)
include("${CMAKE_CURRENT_LIST_DIR}/RoomgraphMrpt.cmake")
roomgraph_need_mrpt(maps)
roomgraph_need_mrpt(viz)
find_dependency(Boost CONFIG)  # headers alone
find_dependency(Ceres)      # the consensus of several runs
find_dependency(CGAL)       # only its kernel, which is LGPL
find_dependency(EXPAT)
find_dependency(JPEG)
find_dependency(OpenSSL)
find_dependency(OpenGL)
find_dependency(PNG)
find_dependency(ZLIB)
find_dependency(yaml-cpp)
find_dependency(PkgConfig)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(sqlite3 REQUIRED IMPORTED_TARGET sqlite3)
