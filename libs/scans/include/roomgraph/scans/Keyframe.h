#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** What a robot saw from one place. */
struct Keyframe {
  std::size_t number = 0;      ///< of the key frame in its file, from 0, with those without a scan
  Transform2D pose;            ///< map <- robot
  std::optional<double> time;  ///< of the scan [s since 1970, UTC]; none where the file has none
  /** The same for the same ranges, whatever the pose and the version of the file: two runs over one
   *  log share their scans. Other scans differ but for chance. */
  std::uint64_t scanId = 0;
  /** Where beams met something, in the order of the scan [m, robot frame]. */
  std::vector<Point> ends;
};

/** Successive key frames, by their numbers in the file, both included; none where the last one is
 *  before the first. */
struct KeyFrames {
  std::size_t from = 1, to = 0;

  [[nodiscard]] bool holds(std::size_t keyFrame) const {
    return from <= keyFrame && keyFrame <= to;
  }
  /** "5", or "5 to 8". */
  [[nodiscard]] std::string text() const {
    return from == to ? std::to_string(from) : std::to_string(from) + " to " + std::to_string(to);
  }
};

}  // namespace roomgraph
