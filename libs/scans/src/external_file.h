#pragma once
#include <string>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

/** Where MOLA puts the files of map NAME, beside it: NAME_Images. */
std::string externalFolder(const std::string& map);

/** Finds a file that a map names: in the folder NAME_Images beside map NAME, where MOLA puts them,
 *  beside the map, where its full name says, or in the folder of another map beside this one, which
 *  was made from that one or had its name: the names of the files hold sensor and time. Empty where
 *  it is nowhere. */
std::string findExternalFile(const std::string& map, const std::string& name);

/** The points of a file of KITTI's: x, y, z and intensity of each as floats. */
CloudPoints kittiPoints(const ByteReader& bytes);
/** The points of a text: a line each, of which the first three numbers count. */
CloudPoints textPoints(const ByteReader& bytes);

}  // namespace roomgraph
