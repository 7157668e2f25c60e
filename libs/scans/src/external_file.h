#pragma once
#include <mrpt/math/TPoint3D.h>

#include <memory>
#include <string>
#include <vector>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

/** Where MOLA puts the files of map NAME, beside it: NAME_Images. */
std::string externalFolder(const std::string& map);

/** Opens a file that a map names: in the folder NAME_Images beside map NAME, where MOLA puts them,
 *  beside the map, where its full name says, or in the folder of another map beside this one, which
 *  was made from that one or had its name: the names of the files hold sensor and time. None where
 *  it is nowhere. */
std::unique_ptr<CheckedFile> openExternalFile(const std::string& map, const std::string& name);

/** The points of a file of KITTI's: x, y, z and intensity of each as floats. */
std::vector<mrpt::math::TPoint3Df> kittiPoints(const ByteReader& bytes);
/** The points of a text: a line each, of which the first three numbers count. */
std::vector<mrpt::math::TPoint3Df> textPoints(const ByteReader& bytes);

}  // namespace roomgraph
