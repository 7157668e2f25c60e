#include "roomgraph/align/alignment_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "roomgraph/align/near_poses.h"
#include "search_images.h"

namespace roomgraph {
namespace {

constexpr int kMaxAcross = 140;     // of the search, across a map
constexpr double kTurnShare = 0.4;  // turns that line up fewer of the walls are left out
constexpr int kRowsAtOnce = 32, kCellsAtOnce = SearchImages::kMargin + 1;  // of the sums
constexpr double kSameAngle = 0.09, kSameShift = 2;  // of peaks that are one [rad, cells]

/** Those that are there several times, as many of a small map are, as one; neighbours among them
 *  take neighbouring rows of one image. */
std::vector<SearchPoint> joined(std::vector<SearchPoint> points) {
  const auto key = [](const SearchPoint& p) { return std::tie(p.octant, p.cell.y, p.cell.x); };
  std::sort(points.begin(), points.end(),
            [&](const SearchPoint& l, const SearchPoint& r) { return key(l) < key(r); });
  std::vector<SearchPoint> joined;
  for (const SearchPoint& point : points)
    if (!joined.empty() && key(joined.back()) == key(point))
      ++joined.back().times;
    else
      joined.push_back(point);
  return joined;
}

/** Sums by shift, from `low` on. */
struct Sums {
  int width = 0, height = 0;
  Cell low;
  std::vector<std::int16_t> values;

  std::int16_t at(int x, int y) const {
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

// Most of the search is these sums: with 16 instead of 8 in one instruction they take half as long.
// Which of them is there is asked before ThreadSanitizer has started, which that does not survive.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define ROOMGRAPH_WIDE_IF_THERE __attribute__((target_clones("avx2", "default")))
#else
#define ROOMGRAPH_WIDE_IF_THERE
#endif

/** Adds, for each point, the image of its octant with the point as its origin: to a sum at shift s
 *  goes the image at s - point. Some rows at a time, so that the sums stay in the nearest cache. */
ROOMGRAPH_WIDE_IF_THERE void add(const std::vector<SearchPoint>& points, const SearchImages& images,
                                 Sums& sums) {
  for (int top = 0; top < sums.height; top += kRowsAtOnce)
    for (const SearchPoint& point : points) {
      const int first = point.cell.y + images.low.y - sums.low.y;
      const int end = std::min({top + kRowsAtOnce, sums.height, first + images.height});
      const auto times = std::int16_t(point.times);
      for (int row = std::max(top, first); row < end; ++row) {
        const SearchImages::Span known = images.known[std::size_t(row - first)];
        const std::int16_t* from =
            images.values[std::size_t(point.octant)].data() + images.index(0, row - first);
        std::int16_t* to = sums.values.data() + std::size_t(row) * std::size_t(sums.width) +
                           (point.cell.x + images.low.x - sums.low.x);
        for (int block = known.first; block < known.end; block += kCellsAtOnce)
          for (int x = block; x < block + kCellsAtOnce; ++x)
            to[x] = std::int16_t(to[x] + times * from[x]);
      }
    }
}

/** What the walls of both maps say about each shift. `plus` and `minus` are points whose images
 *  are `plusImages` and `minusImages`. */
Sums bothWays(const std::vector<SearchPoint>& plus, const SearchImages& plusImages,
              const std::vector<SearchPoint>& minus, const SearchImages& minusImages) {
  CellBox box;
  const auto include = [&](const std::vector<SearchPoint>& points, const SearchImages& images) {
    const auto [low, high] = boundingCells(points);
    box.include({low.x + images.low.x, low.y + images.low.y});
    box.include({high.x + images.low.x + images.width, high.y + images.low.y + images.height});
  };
  include(plus, plusImages);
  include(minus, minusImages);
  Sums sums;
  sums.low = box.low;
  sums.width = box.high.x - box.low.x;
  sums.height = box.high.y - box.low.y;
  sums.values.assign(
      std::size_t(sums.width) * std::size_t(sums.height) + std::size_t(SearchImages::kMargin), 0);
  add(plus, plusImages, sums);
  add(minus, minusImages, sums);
  return sums;
}

struct Peak {
  int score = 0, angle = 0;  ///< index of the angle
  Cell shift;
  bool operator<(const Peak& o) const {
    if (score != o.score) return score > o.score;
    if (angle != o.angle) return angle < o.angle;
    return shift.y != o.shift.y ? shift.y < o.shift.y : shift.x < o.shift.x;
  }
};

bool isPeak(const Sums& sums, int x, int y) {
  const int value = sums.at(x, y);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const int other = sums.at(x + dx, y + dy);
      if (other > value || (other == value && (dy < 0 || (dy == 0 && dx < 0)))) return false;
    }
  return true;
}

/** The best peaks of one angle. */
std::vector<Peak> peaksOf(const Sums& sums, int angle, std::size_t count) {
  std::vector<Peak> peaks;
  int least = 1;
  for (int y = 1; y + 1 < sums.height; ++y)
    for (int x = 1; x + 1 < sums.width; ++x) {
      if (sums.at(x, y) < least || !isPeak(sums, x, y)) continue;
      peaks.push_back({sums.at(x, y), angle, {sums.low.x + x, sums.low.y + y}});
      if (peaks.size() < 4 * count) continue;
      std::sort(peaks.begin(), peaks.end());
      peaks.resize(count);
      least = peaks.back().score;
    }
  std::sort(peaks.begin(), peaks.end());
  if (peaks.size() > count) peaks.resize(count);
  return peaks;
}

std::vector<double> smoothed(const std::vector<double>& turns) {
  const int n = int(turns.size());
  std::vector<double> out(turns.size(), 0);
  for (int i = 0; i < n; ++i)
    for (int d = -3; d <= 3; ++d)
      out[std::size_t(i)] += turns[std::size_t((i + d + n) % n)] * (4 - std::abs(d));
  return out;
}

/** The angles [rad] that turn enough walls of b to face as walls of a do. */
std::vector<double> anglesToTry(const WallMap& a, const WallMap& b) {
  const std::vector<double> from = smoothed(b.turns), to = smoothed(a.turns);
  const std::size_t n = from.size();
  std::vector<double> common(n, 0);
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t i = 0; i < n; ++i) common[r] += from[i] * to[(i + r) % n];
  const double low = *std::min_element(common.begin(), common.end());
  const double high = *std::max_element(common.begin(), common.end());
  std::vector<double> angles;
  for (std::size_t r = 0; r < n; ++r)
    if (common[r] - low >= kTurnShare * (high - low))
      angles.push_back(double(r) * 2 * M_PI / double(n));
  return angles;
}

double searchCell(const WallMap& a, const WallMap& b, double least) {
  const int cells = std::max({a.frame.width, a.frame.height, b.frame.width, b.frame.height});
  const double across = cells * std::max(a.frame.resolution, b.frame.resolution);
  return std::max(least, across / kMaxAcross);
}

/** The best peaks, none near a better one. */
std::vector<AlignmentHypothesis> distinct(std::vector<Peak> peaks,
                                          const std::vector<double>& angles, double cell,
                                          Point pivotA, Point pivotB, int count) {
  std::sort(peaks.begin(), peaks.end());
  const auto angleOf = [&](const Peak& peak) { return angles[std::size_t(peak.angle)]; };
  const auto areSame = [&](const Peak& l, const Peak& r) {
    return std::abs(l.shift.x - r.shift.x) <= kSameShift &&
           std::abs(l.shift.y - r.shift.y) <= kSameShift &&
           std::abs(wrappedAngle(angleOf(l) - angleOf(r))) < kSameAngle;
  };
  std::vector<AlignmentHypothesis> found;
  for (const Peak& peak : distinctBest(peaks, std::size_t(count), areSame)) {
    const Point shift{peak.shift.x * cell, peak.shift.y * cell};
    found.push_back({carrying(pivotB, pivotA + shift, angleOf(peak)), peak.score});
  }
  return found;
}

}  // namespace

std::vector<AlignmentHypothesis> alignmentHypotheses(const WallMap& a, const WallMap& b,
                                                     const SearchEffort& effort) {
  if (a.walls.empty() || b.walls.empty()) return {};
  const double cell = searchCell(a, b, effort.cell);
  const CentredMap fixed = centred(a), moved = centred(b);
  const std::size_t maxPoints = std::size_t(effort.points);
  const auto fixedPoints = joined(searchPoints(fixed, 0, cell, maxPoints, 1));
  const SearchImages fixedImages = imagesOf(fixed, 0, cell, 1);
  const std::vector<double> angles = anglesToTry(a, b);
  std::vector<Peak> peaks;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const auto movedPoints = joined(searchPoints(moved, angles[k], cell, maxPoints, -1));
    const SearchImages movedImages = imagesOf(moved, angles[k], cell, -1);
    const Sums sums = bothWays(movedPoints, fixedImages, fixedPoints, movedImages);
    const auto best = peaksOf(sums, int(k), std::size_t(effort.perAngle));
    peaks.insert(peaks.end(), best.begin(), best.end());
  }
  return distinct(std::move(peaks), angles, cell, a.middle(), b.middle(), effort.poses);
}

}  // namespace roomgraph
