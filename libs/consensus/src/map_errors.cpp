#include "roomgraph/consensus/map_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fitted_consensus.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** Sums over places in two frames, so that the best motion from one to the other and what it
 *  leaves over follow (Umeyama 1991). */
class Displacement {
 public:
  /** Adds points of a submap that lies at `from` in the one frame and at `to` in the other. */
  void add(const PointSums& points, const Transform2D& from, const Transform2D& to) {
    const Moved a(points, from), b(points, to);
    weight_ += points.count;
    from_ = from_ + a.sum, to_ = to_ + b.sum;
    const double turn = to.phi - from.phi, c = std::cos(turn), s = std::sin(turn);
    const double squares = points.xx + points.yy;
    const Point p = from.shift(), q = to.shift();
    const double n = points.count;
    cosine_ += c * squares + dot(a.turned, q) + dot(p, b.turned) + n * dot(p, q);
    sine_ += s * squares + cross(a.turned, q) + cross(p, b.turned) + n * cross(p, q);
    fromSquares_ += squares + 2 * dot(a.turned, p) + n * squaredNorm(p);
    toSquares_ += squares + 2 * dot(b.turned, q) + n * squaredNorm(q);
  }

  double weight() const { return weight_; }

  Transform2D motion() const {
    if (weight_ <= 0) return {};
    return carrying((1 / weight_) * from_, (1 / weight_) * to_, std::atan2(sine(), cosine()));
  }

  /** Root mean square of what the best motion leaves over [m]. */
  double rest() const {
    if (weight_ <= 0) return 0;
    const double squares = fromSquares_ - squaredNorm(from_) / weight_ + toSquares_ -
                           squaredNorm(to_) / weight_ - 2 * std::hypot(cosine(), sine());
    return std::sqrt(std::max(0.0, squares / weight_));
  }

 private:
  struct Moved {
    Point turned, sum;
    Moved(const PointSums& points, const Transform2D& pose)
        : turned(roomgraph::turned({points.x, points.y}, pose.phi)),
          sum(turned + points.count * pose.shift()) {}
  };

  double cosine() const { return cosine_ - dot(from_, to_) / weight_; }
  double sine() const { return sine_ - cross(from_, to_) / weight_; }

  double weight_ = 0, cosine_ = 0, sine_ = 0, fromSquares_ = 0, toSquares_ = 0;
  Point from_, to_;
};

/** Root mean square distance of points at two poses [m]. */
double restAt(const PointSums& points, const Transform2D& l, const Transform2D& r) {
  if (points.count <= 0) return distance(l.shift(), r.shift());
  const Transform2D apart = l.inverse() * r;
  const double c = 1 - std::cos(apart.phi), s = std::sin(apart.phi);
  const double n = points.count;
  const double x = (-c * points.x - s * points.y) / n, y = (s * points.x - c * points.y) / n;
  const double turned = 2 * c * (points.xx + points.yy) / n;  // |R p - p|^2 = 2 (1 - cos) |p|^2
  return std::sqrt(
      std::max(0.0, turned + 2 * (x * apart.x + y * apart.y) + squaredNorm(apart.shift())));
}

/** Of each submap of each run, whether it was found in another run, or another in it. */
std::vector<std::vector<bool>> seenSubmaps(const std::vector<RunSubmaps>& runs,
                                           const std::vector<RunMatches>& matches) {
  std::vector<std::vector<bool>> isSeen;
  for (const RunSubmaps& run : runs) isSeen.emplace_back(run.submaps.size());
  for (const RunMatches& pair : matches)
    for (const SubmapMatch& match : pair.matches)
      isSeen[pair.of][match.submap] = isSeen[pair.in][match.in] = true;
  return isSeen;
}

/** The share of what a run has drawn that others have, too. */
double seenShare(const RunSubmaps& run, const std::vector<bool>& isSeen) {
  double seen = 0, all = 0;
  for (std::size_t k = 0; k < isSeen.size(); ++k) {
    const double count = run.submaps[k].points.count;
    all += count, seen += isSeen[k] ? count : 0;
  }
  return all > 0 ? seen / all : 0;
}

/** e / f - p to e * f + p, see docs/scoring.md, "Map error". */
void addInterval(MapError& error, std::size_t runs) {
  const double others = double(std::max<std::size_t>(2, runs) - 1);
  // Round numbers, so that 75 to 90 % of the true errors lie in it on the sites of
  // benchmarks/README.md, with ten, five and three runs.
  const double factor =
      kEightyPercent * (fitted::kFactor + fitted::kFactorPerRun / others / others +
                        fitted::kFactorUnseen * (1 - error.seen));
  const double place = fitted::kMetres + fitted::kMetresPerRun / others;
  error.low = std::max(0.0, error.error / std::exp(factor) - place);
  error.high = error.error * std::exp(factor) + place;
}

}  // namespace

std::vector<MapError> mapErrors(const std::vector<RunSubmaps>& runs,
                                const std::vector<RunMatches>& matches, const SubmapPoses& poses) {
  auto isSeen = seenSubmaps(runs, matches);
  std::vector<MapError> errors(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& submaps = runs[r].submaps;
    Displacement all;
    for (std::size_t k = 0; k < submaps.size(); ++k)
      all.add(submaps[k].points, submaps[k].pose, poses[r][k]);
    MapError& error = errors[r];
    error.error = all.rest(), error.pose = all.motion();
    error.seen = seenShare(runs[r], isSeen[r]), error.isSeen = std::move(isSeen[r]);
    for (std::size_t k = 0; k < submaps.size(); ++k)
      error.errors.push_back(restAt(submaps[k].points, poses[r][k], error.pose * submaps[k].pose));
    addInterval(error, runs.size());
  }
  return errors;
}

void addLost(MapError& error, const RunSubmaps& run, const std::vector<bool>& isLost) {
  double lost = 0, all = 0;
  for (std::size_t k = 0; k < isLost.size(); ++k) {
    all += run.submaps[k].points.count;
    if (!isLost[k]) continue;
    lost += run.submaps[k].points.count;
    error.errors[k] = std::hypot(error.errors[k], fitted::kLostBy);
  }
  if (lost <= 0) return;
  const double more = fitted::kLostBy * std::sqrt(lost / all);
  error.error = std::hypot(error.error, more);
  error.high = std::hypot(error.high, 2 * more);  // it may lie anywhere
}

}  // namespace roomgraph
