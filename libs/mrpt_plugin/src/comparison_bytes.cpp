#include "comparison_bytes.h"

#include <cmath>

#include "byte_writer.h"
#include "roomgraph/report/comparison_json.h"

namespace roomgraph {
namespace {

const char* const kRemedy = "compare the maps again";

RunWalls readWalls(ByteReader& reader) {
  RunWalls run;
  run.run = reader.getText();
  const auto count = reader.get<std::uint32_t>();
  if (count > reader.left() / (2 * sizeof(float)))
    refuse(reader.file(), "it is cut short or damaged", kRemedy);
  for (std::uint32_t i = 0; i < count; ++i) {
    const float x = reader.get<float>(), y = reader.get<float>();
    if (!std::isfinite(x) || !std::isfinite(y))
      refuse(reader.file(), "a place in it is not a number", kRemedy);
    run.walls.push_back({double(x), double(y)});
  }
  return run;
}

}  // namespace

std::string comparisonBytes(const MappedComparison& comparison) {
  ByteWriter out;
  out.putText(comparisonJson(comparison.comparison));
  out.putCount(comparison.walls.size());
  for (const RunWalls& run : comparison.walls) {
    out.putText(run.run);
    out.putCount(run.walls.size());
    for (const Point wall : run.walls) {
      out.put(float(wall.x));
      out.put(float(wall.y));
    }
  }
  return std::move(out).take();
}

void readComparisonBytes(ByteView bytes, const std::string& name, MappedComparison& comparison) {
  ByteReader reader(bytes, name);
  comparison.comparison = parseComparisonJson(reader.getText(), name);
  comparison.walls.clear();
  const auto count = reader.get<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) comparison.walls.push_back(readWalls(reader));
  if (reader.left() > 0) refuse(name, "something is left over in it", kRemedy);
}

}  // namespace roomgraph
