#pragma once
#include <string>

#include "TestFolder.h"
#include "map_files.h"
#include "roomgraph/scans/read_simplemap.h"

namespace roomgraph::test {

inline Recording recordingIn(const std::string& bytes) {
  const TestFolder dir;
  CheckedFile file(dir.write("map", bytes));
  return readSimplemap(file);
}

}  // namespace roomgraph::test
