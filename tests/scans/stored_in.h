#pragma once
#include <string>

#include "TestFolder.h"
#include "map_files.h"
#include "roomgraph/scans/StoredPose.h"

namespace roomgraph::test {

inline StoredPoses storedIn(const std::string& bytes) {
  const TestFolder dir;
  CheckedFile file(dir.write("map", bytes));
  return readStoredPoses(file);
}

}  // namespace roomgraph::test
