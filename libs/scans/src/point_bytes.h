#pragma once
#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

bool isFinite(const mrpt::math::TPoint3Df& p);

/** The points of three arrays of floats, of which every `stride`th is one's, but for those that are
 *  not finite. */
CloudPoints pointsOf(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                     std::size_t count, std::size_t stride = 1);

/** The same where x, y and z of each point begin `stride` floats. */
inline CloudPoints pointsInRow(const std::uint8_t* bytes, std::size_t count, std::size_t stride) {
  return pointsOf(bytes, bytes + sizeof(float), bytes + 2 * sizeof(float), count, stride);
}

}  // namespace roomgraph
