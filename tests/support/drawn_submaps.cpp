#include "drawn_submaps.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph::test {
namespace {

constexpr double kLong = 20, kShort = 10, kNear = 2;

/** The pose at `s` metres round the block. */
Transform2D poseAt(double s) {
  Transform2D corner;
  for (double side = kLong; s >= side; side = side == kLong ? kShort : kLong) {
    corner = corner * Transform2D{side, 0, M_PI / 2};
    s -= side;
  }
  return corner * Transform2D{s, 0, 0};
}

}  // namespace

Way roundTheBlock(double offset) {
  Way way;
  for (double s = 0; s + 1 <= 2 * (kLong + kShort); ++s) way.push_back(poseAt(s + offset));
  return way;
}

Way drifting(const Way& way, double turn) {
  Way result{way.front()};
  for (std::size_t k = 1; k < way.size(); ++k)
    result.push_back(result.back() * (way[k - 1].inverse() * way[k]) * Transform2D{0, 0, turn});
  return result;
}

Way torn(const Way& way, std::size_t from, double turn, Point shift) {
  const Point at = way[from].shift();
  const Transform2D motion = carrying(at, at + shift, turn);
  Way result = way;
  for (std::size_t k = from; k < way.size(); ++k) result[k] = motion * way[k];
  return result;
}

Way moved(const Way& way, const Transform2D& motion) {
  Way result;
  for (const Transform2D& pose : way) result.push_back(motion * pose);
  return result;
}

const std::vector<Point>& drawnPoints() {
  static const std::vector<Point> points{{3, 2}, {1, 2}, {-1, 2}, {4, -1.5}, {0, -1.5}};
  return points;
}

RunSubmaps drawnSubmaps(const Way& way) {
  RunSubmaps run;
  run.areScans = true;
  for (const Transform2D& pose : way) {
    const auto index = std::uint32_t(run.submaps.size());
    if (index > 0) run.links.push_back({index - 1, index});
    run.submaps.push_back({pose, {}, std::nullopt});
    for (const Point point : drawnPoints()) run.submaps.back().points.add(point);
  }
  return run;
}

std::vector<RunMatches> exactMatches(const std::vector<Way>& truth) {
  std::vector<RunMatches> all;
  for (std::size_t of = 0; of < truth.size(); ++of)
    for (std::size_t in = 0; in < truth.size(); ++in) {
      if (of == in) continue;
      all.push_back({of, in, {}});
      for (std::uint32_t k = 0; k < truth[of].size(); ++k) {
        const auto far = [&](const Transform2D& pose) {
          return distance(pose.shift(), truth[of][k].shift());
        };
        const auto nearest = std::min_element(
            truth[in].begin(), truth[in].end(),
            [&](const Transform2D& l, const Transform2D& r) { return far(l) < far(r); });
        if (far(*nearest) > kNear) continue;
        const auto found = std::uint32_t(nearest - truth[in].begin());
        all.back().matches.push_back({k, found, nearest->inverse() * truth[of][k], 1, false});
      }
    }
  return all;
}

double displacement(const Way& way, const Way& truth) {
  MotionFit fit;
  for (std::size_t k = 0; k < way.size(); ++k)
    for (const Point point : drawnPoints()) fit.add(way[k](point), truth[k](point));
  const Transform2D motion = fit.motion();
  double squares = 0;
  for (std::size_t k = 0; k < way.size(); ++k)
    for (const Point point : drawnPoints())
      squares += squaredNorm(motion(way[k](point)) - truth[k](point));
  return std::sqrt(squares / fit.weight());
}

double misplaced(const SubmapPoses& poses, const std::vector<Way>& truth) {
  MotionFit fit;
  for (std::size_t r = 0; r < truth.size(); ++r)
    for (std::size_t k = 0; k < truth[r].size(); ++k)
      fit.add(poses[r][k].shift(), truth[r][k].shift());
  const Transform2D motion = fit.motion();
  double squares = 0;
  for (std::size_t r = 0; r < truth.size(); ++r)
    for (std::size_t k = 0; k < truth[r].size(); ++k)
      squares += squaredNorm(motion(poses[r][k].shift()) - truth[r][k].shift());
  return std::sqrt(squares / fit.weight());
}

}  // namespace roomgraph::test
