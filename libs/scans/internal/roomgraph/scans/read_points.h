#pragma once
#include <functional>
#include <string>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

/** Steps over what all classes of point maps begin with: a count, then all x, all y, all z. What
 *  comes back decodes it, from the same bytes. Points that are not finite are left out. */
std::function<CloudPoints()> skipPoints(ByteReader& reader);
/** Decodes them at once. */
inline CloudPoints readPoints(ByteReader& reader) { return skipPoints(reader)(); }

/** Whether it is one of MRPT's classes of point maps. */
bool isPointsMapClass(const std::string& className);

}  // namespace roomgraph
