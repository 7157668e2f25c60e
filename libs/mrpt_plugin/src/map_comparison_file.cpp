#include "roomgraph/mrpt_plugin/map_comparison_file.h"

#include "object_bytes.h"

namespace roomgraph {

std::string mapComparisonBytes(const CMapComparison& comparison) {
  return gzippedObject(comparison);
}

CMapComparison loadMapComparison(const std::string& path) {
  CMapComparison comparison;
  readObjectFile(path, kMapComparisonObject,
                 [&](ByteView body) { readComparisonBytes(body, path, comparison); });
  return comparison;
}

}  // namespace roomgraph
