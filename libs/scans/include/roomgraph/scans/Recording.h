#pragma once
#include <mrpt/poses/CPose3D.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/RangeScan.h"

namespace roomgraph {

/** What a run has recorded: a file with scans, opened, inflated and decoded once. The grid of the
 *  run, its key frames, its log and what is told of it are made from this. */
struct Recording {
  /** What was recorded at one place. Its number is its index, from 0, in the order of the file. */
  struct Frame {
    mrpt::poses::CPose3D robot;      ///< map <- robot
    std::size_t begin = 0, end = 0;  ///< of a simplemap: its bytes in the inflated file
    std::vector<RangeScan> scans;
    std::vector<PointCloud> clouds;

    /** Of its first scan or cloud that has one [s since 1970, UTC]. */
    [[nodiscard]] std::optional<double> time() const;
  };
  /** A kind of observation, whether it is used or stepped over. */
  struct Sensor {
    std::string className;
    int version = 0;    ///< of the class
    std::string label;  ///< empty where the class is not known here

    /** For people: "LABEL (CLASS VERSION)". */
    [[nodiscard]] std::string name() const;
    bool operator<(const Sensor& other) const;
  };

  std::string file;    ///< as the caller named it
  std::string sha256;  ///< of its bytes
  int version = 0;     ///< of its format
  Compression compression = Compression::none;
  std::vector<Frame> frames;
  std::map<Sensor, std::size_t> sensors;     ///< how often each has been read
  std::shared_ptr<const CheckedFile> bytes;  ///< where the points of its clouds are read from

  [[nodiscard]] std::size_t framesWithoutScans() const;  ///< and without clouds
  [[nodiscard]] double pathLength() const;               ///< from pose to pose [m]
  /** Of the first and the last scan or cloud that has a time [s since 1970]; none without any. */
  [[nodiscard]] std::optional<std::pair<double, double>> times() const;
};

}  // namespace roomgraph
