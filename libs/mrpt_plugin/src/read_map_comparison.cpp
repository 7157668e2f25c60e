#include "roomgraph/mrpt_plugin/read_map_comparison.h"

#include "comparison_bytes.h"
#include "object_file.h"

namespace roomgraph {

MappedComparison readMapComparison(const std::string& path) {
  MappedComparison comparison;
  readObjectFile(path,
                 {"CMapComparison", "comparison of maps", "give a comparison.roomgraph",
                  kComparisonBytesVersion},
                 [&](ByteView body) { readComparisonBytes(body, path, comparison); });
  return comparison;
}

}  // namespace roomgraph
