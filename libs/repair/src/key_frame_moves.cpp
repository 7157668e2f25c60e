#include "roomgraph/repair/key_frame_moves.h"

#include <mrpt/math/CQuaternion.h>

#include <cmath>
#include <optional>

#include "roomgraph/base/compressed.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

/** A time for each key frame [s]. */
std::vector<double> timesOf(const std::vector<Recording::Frame>& frames) {
  std::vector<std::size_t> timed;
  for (std::size_t k = 0; k < frames.size(); ++k)
    if (frames[k].time()) timed.push_back(k);
  std::vector<double> times;
  std::size_t next = 0;  // of `timed`
  for (std::size_t k = 0; k < frames.size(); ++k) {
    while (next < timed.size() && timed[next] < k) ++next;
    if (timed.empty()) {
      times.push_back(double(k));
    } else if (next == 0 || next == timed.size()) {
      times.push_back(*frames[timed[next == 0 ? 0 : next - 1]].time());
    } else {
      const std::size_t from = timed[next - 1], to = timed[next];
      const double share = double(k - from) / double(to - from);
      times.push_back((1 - share) * *frames[from].time() + share * *frames[to].time());
    }
    if (next < timed.size() && timed[next] == k) times.back() = *frames[k].time();
  }
  return times;
}

/** How sure a pose between two is: 0 is the one, 1 the other. */
PlanarCovariance between(const PlanarCovariance& l, const PlanarCovariance& r, double share) {
  const auto mix = [&](double PlanarCovariance::*of) {
    return (1 - share) * l.*of + share * r.*of;
  };
  using C = PlanarCovariance;
  return {mix(&C::xx), mix(&C::yy), mix(&C::pp), mix(&C::xy), mix(&C::xp), mix(&C::yp)};
}

/** Between two motions of a pose: 0 is the one, 1 the other. */
Transform2D between(const Transform2D& one, const Transform2D& other, double share,
                    const Transform2D& pose) {
  const Transform2D from = one * pose, to = other * pose;
  const Point place = (1 - share) * from.shift() + share * to.shift();
  const double turn = wrappedAngle(to.phi - from.phi);
  return Transform2D{place.x, place.y, wrappedAngle(from.phi + share * turn)} * pose.inverse();
}

mrpt::math::CQuaternionDouble turnOf(const Recording::Frame& frame) {
  mrpt::math::CQuaternionDouble turn;
  frame.robot.getAsQuaternion(turn);
  return turn;
}

Transform2D planar(const Recording::Frame& frame) {
  const auto q = turnOf(frame);
  return {frame.robot.x(), frame.robot.y(),
          std::atan2(2 * (q.r() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()))};
}

}  // namespace

std::string trajectoryTum(const Recording& recording, const std::vector<PoseMove>& moves) {
  const std::vector<double> times = timesOf(recording.frames);
  std::string text;
  for (std::size_t k = 0; k < recording.frames.size(); ++k) {
    const mrpt::poses::CPose3D& robot = recording.frames[k].robot;
    const auto turn = turnOf(recording.frames[k]);
    const Transform2D& motion = moves[k].motion;
    const Point place = motion({robot.x(), robot.y()});
    const Point xy = turned({turn.x(), turn.y()}, motion.phi / 2);
    const Point wz = turned({turn.r(), turn.z()}, motion.phi / 2);
    text += formatted("%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", times[k], place.x, place.y,
                      robot.z(), xy.x, xy.y, wz.y, wz.x);
  }
  return text;
}

std::vector<PoseMove> keyFrameMoves(const Run& run, const RepairedRun& repaired,
                                    const Recording& recording) {
  std::vector<PoseMove> moves(recording.frames.size());
  if (repaired.state != RepairState::mended || run.scans.empty()) return moves;
  std::vector<std::optional<Transform2D>> known(moves.size());
  std::vector<PlanarCovariance> sure(moves.size());
  for (std::size_t k = run.scans.size(); k-- > 0;) {  // of several scans of one key frame the first
    known.at(run.scans[k].keyFrame) = repaired.poses[k] * run.scans[k].pose.inverse();
    if (!repaired.covariances.empty()) sure[run.scans[k].keyFrame] = repaired.covariances[k];
  }
  std::optional<std::size_t> before;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    std::size_t next = k;
    while (next < moves.size() && !known[next]) ++next;
    if (next == k) before = k;
    if (!before) before = next;
    if (next == moves.size()) next = *before;
    const double share = next > *before ? double(k - *before) / double(next - *before) : 0;
    moves[k].motion = between(*known[*before], *known[next], share, planar(recording.frames[k]));
    if (!repaired.covariances.empty())
      moves[k].covariance = between(sure[*before], sure[next], share);
  }
  return moves;
}

std::string packedMap(const std::string& content, Compression how) {
  return how == Compression::gzip ? gzipped(content, kGzipMark) : compressed(content, how);
}

}  // namespace roomgraph
