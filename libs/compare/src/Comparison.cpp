#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

bool Comparison::isPlaceDoubtful(const std::string& run) const {
  int sure = 0, doubtful = 0;
  for (const ComparedPair& pair : pairs)
    if (pair.isSameSite && (pair.a == run || pair.b == run))
      ++(pair.confidence < kSureConfidence ? doubtful : sure);
  return doubtful > sure;
}

}  // namespace roomgraph
