#pragma once
#include <mrpt/math/TPoint3D.h>

#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

/** Reads what all classes of point maps begin with: a count, then all x, all y, all z. Points that
 *  are not finite are left out. */
std::vector<mrpt::math::TPoint3Df> readPoints(ByteReader& in);

/** Whether it is one of MRPT's classes of point maps. */
bool isPointsMapClass(const std::string& className);

}  // namespace roomgraph
