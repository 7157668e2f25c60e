#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "RandomNumbers.h"
#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph::test {

/** A drive along the corridor of a building, once. */
inline const std::vector<Keyframe>& driveOnce() {
  static const std::vector<Keyframe> frames = drawnDrive(drawnBuilding(4, {}));
  return frames;
}

/** And back again, backwards, over the same places. */
inline std::vector<Keyframe> driveForthAndBack() {
  std::vector<Keyframe> frames = driveOnce();
  for (std::size_t k = frames.size(); k-- > 0;) frames.push_back(frames[k]);
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k].number = k;
  return frames;
}

/** The same with each frame off on its own, by a standard deviation of so much each way [m]. */
inline std::vector<Keyframe> shaken(std::vector<Keyframe> frames, double by) {
  RandomNumbers random(5);
  for (Keyframe& frame : frames) {
    const Point off = random.place(std::sqrt(3.0) * by);
    frame.pose.x += off.x, frame.pose.y += off.y;
  }
  return frames;
}

inline Run runOf(const std::vector<Keyframe>& frames) {
  Run run;
  run.name = "run";
  run.scans = scanWalls(frames);
  return run;
}

inline std::vector<Transform2D> posesOf(const std::vector<Keyframe>& frames) {
  std::vector<Transform2D> poses;
  for (const Keyframe& frame : frames) poses.push_back(frame.pose);
  return poses;
}

/** How far the steps of one run differ from those of another, at most [m and rad together]. */
inline double stepsApart(const std::vector<Transform2D>& a, const std::vector<Transform2D>& b) {
  double most = 0;
  for (std::size_t k = 1; k < a.size(); ++k) {
    const Transform2D l = a[k - 1].inverse() * a[k], r = b[k - 1].inverse() * b[k];
    most = std::max(most, distance(l.shift(), r.shift()) + std::abs(wrappedAngle(l.phi - r.phi)));
  }
  return most;
}

}  // namespace roomgraph::test
