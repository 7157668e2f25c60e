#pragma once
#include <optional>
#include <string>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

/** Where MOLA puts the files of map NAME, beside it: NAME_Images. */
std::string externalFolder(const std::string& map);

struct ExternalFile {
  std::string file;
  std::string otherFolder;  ///< that it is in, where that is named after another map
};

/** Finds a file that a map names: in the folder NAME_Images beside map NAME, where MOLA puts them,
 *  or below it, and beside the map or below that. A map that was renamed has its files in a folder
 *  of another name: where there is no NAME_Images, but exactly one such folder whose own map is
 *  not beside it, that one counts. A map has no say in which other files of the computer are
 *  looked at: of a name that leads out of these folders only the last part counts. None where it
 *  is nowhere. */
std::optional<ExternalFile> findExternalFile(const std::string& map, const std::string& name);

/** The points of a file of KITTI's: x, y, z and intensity of each as floats. */
CloudPoints kittiPoints(const ByteReader& bytes);
/** The points of a text: a line each, of which the first three numbers count. */
CloudPoints textPoints(const ByteReader& bytes);

}  // namespace roomgraph
