#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

/** What a simplemap tells of the run that made it. */
struct RunInfo {
  std::string sha256;                                    ///< of the file
  int version = 0;                                       ///< of CSimpleMap
  Compression compression = Compression::none;           ///< of the file
  std::size_t keyframes = 0, keyframesWithoutScans = 0;  ///< how many there are
  double pathLength = 0;                                 ///< from pose to pose [m]
  std::optional<double> start, end;  ///< of the first and last scan that has a time [s since 1970]
  /** How often each sensor has been read, by "LABEL (CLASS VERSION)"; without a label where the
   *  observation has none that is known here. */
  std::map<std::string, std::size_t> sensors;
};

}  // namespace roomgraph
