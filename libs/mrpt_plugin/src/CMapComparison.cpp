#include "roomgraph/mrpt_plugin/CMapComparison.h"

#include <cmath>

#include "object_bytes.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/map_comparison_file.h"
#include "roomgraph/report/comparison_json.h"

IMPLEMENTS_SERIALIZABLE(CMapComparison, CSerializable, roomgraph)

namespace roomgraph {
namespace {

std::string breakLine(const MapBreak& tear, bool isDoubtful) {
  std::string line = "  " + tear.run +
                     formatted(" at (%.2f, %.2f) m, by %.1f deg and %.2f m", tear.place.x,
                               tear.place.y, tear.rotation * 180 / M_PI, tear.shift);
  if (tear.keyFrame) line += ", from key frame " + std::to_string(*tear.keyFrame) + " on";
  if (tear.time) line += ", " + timeText(*tear.time);
  return line + (isDoubtful ? ", doubtful\n" : "\n");
}

}  // namespace

CMapComparison::CMapComparison(Comparison compared, const std::vector<Run>& runs)
    : MappedComparison{std::move(compared), runWalls(runs)} {}

std::string CMapComparison::asString() const {
  std::string text = comparison.verdict + "\n\n" + comparisonText(comparison);
  if (!comparison.breaks.empty()) text += "\nBreaks\n";
  for (const MapBreak& tear : comparison.breaks)
    text += breakLine(tear, comparison.isPlaceDoubtful(tear.run));
  return text;
}

void CMapComparison::getVisualizationInto(viz::CSetOfObjects& container) const {
  container.insert(drawComparison(comparison, walls));
}

uint8_t CMapComparison::serializeGetVersion() const { return kMapComparisonObject.newest; }

void CMapComparison::serializeTo(mrpt::serialization::CArchive& out) const {
  putBody(out, comparisonBytes(*this));
}

void CMapComparison::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version) {
  readBody(in, version, kMapComparisonObject,
           [&](ByteView body) { readComparisonBytes(body, kMapComparisonObject.name, *this); });
}

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
