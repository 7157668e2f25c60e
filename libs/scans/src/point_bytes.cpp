#include "point_bytes.h"

#include <cmath>

namespace roomgraph {

using mrpt::math::TPoint3Df;

bool isFinite(const TPoint3Df& p) {
  // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): MRPT's constructors set all three
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

CloudPoints pointsOf(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                     std::size_t count, std::size_t stride) {
  CloudPoints points;
  points.reserve(count);
  for (std::size_t i = 0; i < count * stride; i += stride) {
    const TPoint3Df p(valueAt<float>(x, i), valueAt<float>(y, i), valueAt<float>(z, i));
    if (isFinite(p)) points.push_back(p);
  }
  return points;
}

}  // namespace roomgraph
