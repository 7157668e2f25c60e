#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/breaks/MapBreak.h"

namespace roomgraph {

/** What a key frame of a run that is checked by itself is known by. */
struct CheckedPose {
  std::size_t keyFrame = 0;    ///< its number in the file of the run, from 0
  std::optional<double> time;  ///< of its scan [s since 1970]
  Transform2D pose;            ///< run <- robot, as it was drawn
  Transform2D agreed;          ///< run <- robot, as it would lie if the run agreed with itself
  double error = 0;            ///< how far what it has drawn lies from that, RMS [m]
  bool isSeenTwice = false;    ///< whether its place was seen at another time as well
};

/** What a run tells of itself. */
struct RunCheck {
  std::string name, file, sha256;
  /** How far the run is from agreeing with itself: RMS displacement of what it has drawn against
   *  its self-consensus, after the best turn and shift, and an interval [m]. None where nothing can
   *  be told. Not the map error of a comparison: what was driven once may bend as it likes. */
  std::optional<double> selfError;
  double low = 0, high = 0;
  double seenTwice = 0;  ///< share of its path that was seen at another time as well, 0 to 1
  /** Those of which nothing tells how large they are have no `torn`, and come last. */
  std::vector<MapBreak> breaks;   ///< in the frame of the run, the largest first
  std::vector<CheckedPose> path;  ///< by key frame
  /** Whether what was seen twice bears out all breaks, and fits where the path is as agreed. */
  bool isConfirmed = false;
  std::string sentence;                 ///< for people: what can be told, and what cannot
  std::vector<std::string> complaints;  ///< of a gate; none where it passes
};

/** Where the key frames would lie if the run agreed with itself: run <- robot, by key frame. */
[[nodiscard]] inline std::vector<Transform2D> agreedPoses(const RunCheck& check) {
  std::vector<Transform2D> poses;
  for (const CheckedPose& at : check.path) poses.push_back(at.agreed);
  return poses;
}

}  // namespace roomgraph
