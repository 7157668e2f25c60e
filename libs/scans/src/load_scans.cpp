#include "roomgraph/scans/load_scans.h"

#include "roomgraph/scans/object_header.h"
#include "roomgraph/scans/read_keyframes.h"

namespace roomgraph {

std::vector<RobotScan> loadScans(const std::string& name, const LoadGridOptions& options) {
  CheckedFile file(name);
  if (!announcesSimplemap(file.head())) return {};
  return readRobotScans(file, options);
}

}  // namespace roomgraph
