#include "roomgraph/mrpt_plugin/CMapComparison.h"

#include "comparison_bytes.h"
#include "object_body.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/map_comparison_text.h"

IMPLEMENTS_SERIALIZABLE(CMapComparison, CSerializable, roomgraph)

namespace roomgraph {
namespace {

const char* const kComparisonStream = "comparison of maps";

}  // namespace

CMapComparison::CMapComparison(Comparison compared, const std::vector<Run>& runs)
    : MappedComparison{std::move(compared), runWalls(runs)} {}

std::string CMapComparison::asString() const { return mapComparisonText(comparison); }

void CMapComparison::getVisualizationInto(viz::CSetOfObjects& container) const {
  container.insert(drawComparison(comparison, walls));
}

uint8_t CMapComparison::serializeGetVersion() const { return kComparisonBytesVersion; }

void CMapComparison::serializeTo(mrpt::serialization::CArchive& out) const {
  putBody(out, comparisonBytes(*this));
}

void CMapComparison::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version) {
  const std::string bytes = takeBody(in, {kComparisonStream, version, kComparisonBytesVersion});
  readComparisonBytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                      kComparisonStream, *this);
}

}  // namespace roomgraph
