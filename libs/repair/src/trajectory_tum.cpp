#include "roomgraph/repair/trajectory_tum.h"

#include <cmath>

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

/** A time for each key frame [s]. */
std::vector<double> timesOf(const std::vector<StoredPose>& frames) {
  std::vector<std::size_t> timed;
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (frames[k].time) timed.push_back(k);
  std::vector<double> times;
  std::size_t next = 0;  // of `timed`
  for (std::size_t k = 0; k < frames.size(); ++k) {
    while (next < timed.size() && timed[next] < k) ++next;
    if (timed.empty()) {
      times.push_back(double(k));
    } else if (next == 0 || next == timed.size()) {
      times.push_back(*frames[timed[next == 0 ? 0 : next - 1]].time);
    } else {
      const std::size_t from = timed[next - 1], to = timed[next];
      const double share = double(k - from) / double(to - from);
      times.push_back((1 - share) * *frames[from].time + share * *frames[to].time);
    }
    if (next < timed.size() && timed[next] == k) times.back() = *frames[k].time;
  }
  return times;
}

}  // namespace

std::string trajectoryTum(const StoredPoses& stored, const std::vector<PoseMove>& moves) {
  const std::vector<double> times = timesOf(stored.frames);
  std::string text;
  for (std::size_t k = 0; k < stored.frames.size(); ++k) {
    const StoredPose& pose = stored.frames[k];
    const Transform2D& motion = moves[k].motion;
    const Point place = motion({pose.place[0], pose.place[1]});
    const Point xy = turned({pose.turn[0], pose.turn[1]}, motion.phi / 2);
    const Point wz = turned({pose.turn[3], pose.turn[2]}, motion.phi / 2);
    text += formatted("%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", times[k], place.x, place.y,
                      pose.place[2], xy.x, xy.y, wz.y, wz.x);
  }
  return text;
}

}  // namespace roomgraph
