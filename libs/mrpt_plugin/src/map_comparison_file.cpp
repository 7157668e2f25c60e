#include "roomgraph/mrpt_plugin/map_comparison_file.h"

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/read_map_comparison.h"

namespace roomgraph {

std::string mapComparisonBytes(const CMapComparison& comparison) {
  return gzippedObject(comparison);
}

CMapComparison loadMapComparison(const std::string& path) {
  CMapComparison comparison;
  static_cast<MappedComparison&>(comparison) = readMapComparison(path);
  return comparison;
}

}  // namespace roomgraph
