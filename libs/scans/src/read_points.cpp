#include "roomgraph/scans/read_points.h"

#include "point_bytes.h"

namespace roomgraph {

std::function<CloudPoints()> skipPoints(ByteReader& in) {
  const std::uint64_t count = in.get<std::uint32_t>();
  const std::uint8_t* x = in.take(count * sizeof(float));
  const std::uint8_t* y = in.take(count * sizeof(float));
  const std::uint8_t* z = in.take(count * sizeof(float));
  return [=] { return pointsOf(x, y, z, count); };
}

bool isPointsMapClass(const std::string& className) {
  return className.find("Points") != std::string::npos && className[0] == 'C';
}

}  // namespace roomgraph
