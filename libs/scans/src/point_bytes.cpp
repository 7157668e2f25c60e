#include "point_bytes.h"

#include <cmath>

namespace roomgraph {

using mrpt::math::TPoint3Df;

bool isFinite(const TPoint3Df& p) {
  // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): MRPT's constructors set all three
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

float floatAt(const std::uint8_t* bytes, std::size_t index) {
  float value;
  std::memcpy(&value, bytes + index * sizeof value, sizeof value);
  return value;
}

CloudPoints pointsOf(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                     std::size_t count) {
  CloudPoints points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const TPoint3Df p(floatAt(x, i), floatAt(y, i), floatAt(z, i));
    if (isFinite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace roomgraph
