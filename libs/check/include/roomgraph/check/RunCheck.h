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

/** A figure that speaks for or against a run: a row of a table. */
struct Evidence {
  std::string name;              ///< as in the files
  std::string label;             ///< for people
  std::string unit;              ///< "m", "deg", or "1" for a share of 1
  std::optional<double> drawn;   ///< of the run as it was drawn; none where nothing supports it
  std::optional<double> agreed;  ///< as it would be if the run agreed with itself, if that is told
  double support = 0;            ///< how many things were counted: steps, revisits, or walls
};

/** A stretch of a run, and where it has drawn a place. */
struct DrawnStretch {
  std::size_t first = 0, last = 0;  ///< key frames
  std::size_t keyFrame = 0;         ///< the one of them at which the two lie farthest apart
  std::optional<double> time;       ///< of its scan [s since 1970]
  Point place;  ///< where it has drawn what is at that place [m, frame of the run]
};

/** A place that was drawn at two times, the second time elsewhere. */
struct DoubledPlace {
  DrawnStretch one, other;  ///< in their order in the run
  double apart = 0;         ///< from the one place to the other, at most [m]
  Transform2D mend;         ///< the motion that lays what `other` has drawn on what `one` has
};

/** Two places that lie over each other and are not one: each sees through walls of the other. */
struct WeldedPlace {
  DrawnStretch one, other;  ///< in their order in the run
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
  std::vector<DoubledPlace> doubled;  ///< that no break explains, the farthest apart first
  std::vector<WeldedPlace> welded;    ///< the largest first
  std::vector<Evidence> evidence;
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
