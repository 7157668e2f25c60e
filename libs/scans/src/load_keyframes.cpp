#include "roomgraph/scans/load_keyframes.h"

#include "roomgraph/scans/object_header.h"
#include "roomgraph/scans/read_keyframes.h"

namespace roomgraph {

std::vector<Keyframe> loadKeyframes(const std::string& name, const LoadGridOptions& options) {
  CheckedFile file(name);
  if (!announcesSimplemap(file.head())) return {};
  return readKeyframes(file, options);
}

std::vector<Keyframe> loadKeyframes(const std::string& name, double maxRange) {
  LoadGridOptions options;
  options.maxDistanceInsertion = maxRange;
  return loadKeyframes(name, options);
}

}  // namespace roomgraph
