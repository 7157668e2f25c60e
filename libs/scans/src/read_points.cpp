#include "roomgraph/scans/read_points.h"

#include "point_bytes.h"

namespace roomgraph {

std::function<CloudPoints()> skipPoints(ByteReader& reader) {
  const std::uint64_t count = reader.get<std::uint32_t>();
  const std::uint8_t* x = reader.take(count * sizeof(float));
  const std::uint8_t* y = reader.take(count * sizeof(float));
  const std::uint8_t* z = reader.take(count * sizeof(float));
  return [=] { return pointsOf(x, y, z, count); };
}

bool isPointsMapClass(const std::string& className) {
  return className.find("Points") != std::string::npos && className[0] == 'C';
}

}  // namespace roomgraph
