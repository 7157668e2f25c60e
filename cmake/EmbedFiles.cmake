# Turns text files into one C++ source with a constant for each:
#   cmake -D OUTPUT=page_files.cpp -D HEADER=page_files.h -D NAMESPACE=roomgraph::page_files
#         -D FILES=kReportHtml=report.html,kLeafletJs=leaflet.min.js -P EmbedFiles.cmake
# References to other files (source maps, pictures of style sheets) are dropped: what is embedded
# must need no other file.
string(REPLACE "," ";" files "${FILES}")
set(source "// Made by EmbedFiles.cmake.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
foreach(file IN LISTS files)
  string(REGEX MATCH "^([^=]+)=(.+)$" ignored "${file}")
  set(name "${CMAKE_MATCH_1}")
  file(READ "${CMAKE_MATCH_2}" text)
  string(REGEX REPLACE "(//|/\\*)# sourceMappingURL=[^\n]*" "" text "${text}")
  string(REGEX REPLACE "url\\(['\"]?images/[^)]*\\)" "none" text "${text}")
  string(FIND "${text}" ")embedded\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${CMAKE_MATCH_2}: holds the text that ends a constant")
  endif()
  string(APPEND source "\nconst char* const ${name} = R\"embedded(${text})embedded\";\n")
endforeach()
string(APPEND source "\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${source}")
