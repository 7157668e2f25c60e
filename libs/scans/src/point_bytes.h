#pragma once
#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

bool isFinite(const mrpt::math::TPoint3Df& p);

/** The float of that index in an array of any alignment. */
float floatAt(const std::uint8_t* bytes, std::size_t index);

/** The points of three arrays of floats, but for those that are not finite. */
CloudPoints pointsOf(const std::uint8_t* x, const std::uint8_t* y, const std::uint8_t* z,
                     std::size_t count);

}  // namespace roomgraph
