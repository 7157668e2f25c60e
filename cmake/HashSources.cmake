# Writes a header with one hash over all sources of some libraries:
#   cmake -D OUTPUT=related_sources.h -D NAME=kRelatedSources -D ROOT=libs -D LIBS=align,relate
#         -P HashSources.cmake
string(REPLACE "," ";" libs "${LIBS}")
foreach(lib IN LISTS libs)
  file(GLOB_RECURSE sources "${ROOT}/${lib}/*.h" "${ROOT}/${lib}/*.cpp")
  foreach(source IN LISTS sources)
    file(SHA256 "${source}" hash)
    string(APPEND hashes "${hash}\n")
  endforeach()
endforeach()
string(SHA256 hash "${hashes}")
file(WRITE "${OUTPUT}" "#pragma once\n\n"
  "// Made by HashSources.cmake.\nconstexpr char ${NAME}[] = \"${hash}\";\n")
