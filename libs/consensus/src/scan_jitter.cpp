#include "scan_jitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fitted_consensus.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/majority.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

constexpr double kAlike = 0.8;              // cosine, of walls that are the same
constexpr double kMostApart = 0.5;          // of two scans; beyond, it is a break [m]
constexpr std::size_t kLeastMeeting = 15;   // of a scan that meet some of another
constexpr double kLeastAlike = 10;          // scans that see what those before them do
constexpr double kMedianOfNormal = 0.6745;  // of its absolute values, by its standard deviation

using Walls = std::vector<WallPoint>;

/** Squared distance to the nearest wall that faces the same way, across it. */
std::optional<double> squaredGap(const WallPoint& wall, const Walls& others) {
  std::optional<double> least;
  for (const WallPoint& other : others) {
    const Point off = other.place - wall.place;
    if (squaredNorm(off) > WallMap::kReach * WallMap::kReach) continue;
    if (dot(other.normal, wall.normal) < kAlike) continue;
    const double across = dot(off, other.normal);
    const double along = std::max(0.0, std::abs(cross(off, other.normal)) - 2 * kSameWall);
    const double far = across * across + along * along;
    if (!least || far < *least) least = far;
  }
  return least;
}

/** How far one scan lies off another, as the walls tell that both have. */
std::optional<double> apart(const Walls& scan, const Walls& other) {
  std::vector<double> gaps;
  for (const WallPoint& wall : scan)
    if (const auto gap = squaredGap(wall, other)) gaps.push_back(std::sqrt(*gap));
  if (gaps.size() < kLeastMeeting || double(gaps.size()) < kMajority * double(scan.size()))
    return std::nullopt;
  return std::min(kMostApart, median(std::move(gaps)) / kMedianOfNormal);
}

/** Squared distance of a scan from those one, two and three steps before it, where all of these see
 *  the same. */
std::optional<std::array<double, 3>> squaresOf(const std::vector<Walls>& scans, std::size_t k) {
  std::array<double, 3> squares{};
  for (std::size_t steps = 1; steps <= 3; ++steps) {
    const auto far = apart(scans[k], scans[k - steps]);
    if (!far) return std::nullopt;
    squares[steps - 1] = *far * *far;
  }
  return squares;
}

}  // namespace

double scanJitter(const std::vector<ScanWalls>& scans, const std::vector<Transform2D>& carries) {
  std::vector<Walls> there(scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const Motion2D carry(carries[k]);
    for (const WallPoint& wall : scans[k].walls)
      there[k].push_back({carry(wall.place), carry.turned(wall.normal)});
  }
  double sum = 0, count = 0;
  for (std::size_t k = 3; k < there.size(); ++k)
    if (const auto squares = squaresOf(there, k)) {
      const auto& [one, two, three] = *squares;
      sum += (4 * one + two - 2 * three) / 3, ++count;  // the line by least squares, at 0
    }
  return count >= kLeastAlike ? std::sqrt(std::max(0.0, sum / count)) : 0;
}

void addJitter(Consensus& consensus, const Site& site) {
  for (const RunId run : consensus.graph.runs.ids()) {
    std::vector<ScanWalls> scans = site.runs[consensus.siteRuns[run]]->scans;
    if (run == consensus.graph.reference || scans.empty()) continue;
    MapError& error = consensus.errors[run];
    for (std::size_t k = 0; k < scans.size(); ++k)
      if (!error.isSeen[k]) scans[k].walls.clear();  // where nobody found it, it may lie anywhere
    std::vector<Transform2D> carries;
    for (const NodeId node : consensus.graph.runs[run].nodes)
      carries.push_back(consensus.poses[node] * consensus.graph.nodes[node].pose.inverse());
    const std::vector<Transform2D> asDrawn(scans.size());
    const double jitter = std::min(scanJitter(scans, asDrawn), scanJitter(scans, carries));
    if (jitter <= fitted::kUsualJitter) continue;
    const double more = std::sqrt(jitter * jitter - fitted::kUsualJitter * fitted::kUsualJitter);
    error.jitter = jitter;
    error.error = std::hypot(error.error, more);
    error.low = std::hypot(error.low, more / fitted::kJitterFactor);
    error.high = std::hypot(error.high, more * fitted::kJitterFactor);
    for (double& each : error.errors) each = std::hypot(each, more);
  }
}

}  // namespace roomgraph
