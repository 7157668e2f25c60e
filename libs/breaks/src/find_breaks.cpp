#include "roomgraph/breaks/find_breaks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "find_wide_breaks.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMinSteps = 20;  // of a track, to know what is usual
constexpr double kOutlier = 4;         // times the 95th percentile of the run's other steps

/** The change of a run's pose in another map from one scan to the next that was found. */
struct Jump {
  std::size_t scan = 0, before = 0;
  double rotation = 0, shift = 0;
};

std::vector<Jump> stepsOf(const std::vector<ScanWalls>& scans, const ScanTrack& track) {
  std::vector<Jump> steps;
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (!track[k]) continue;
    if (last) {
      const Transform2D &from = *track[*last], &to = *track[k];
      // The map shows the run's error the other way round.
      steps.push_back({k, *last, wrappedAngle(from.phi - to.phi),
                       distance(from(scans[k].robot()), to(scans[k].robot()))});
    }
    last = k;
  }
  return steps;
}

double usual(const std::vector<Jump>& steps, double (*size)(const Jump&)) {
  std::vector<double> sizes;
  for (const Jump& step : steps) sizes.push_back(size(step));
  return quantile(std::move(sizes), 0.95);
}

double rotationOf(const Jump& step) { return std::abs(step.rotation); }
double shiftOf(const Jump& step) { return step.shift; }

/** The jumps of one track that stand out of it. */
class JumpFinder {
 public:
  JumpFinder(const std::vector<Jump>& steps, const FindBreaksOptions& options)
      : steps_(steps), options_(options) {}

  std::vector<Jump> find() const {
    std::vector<Jump> found;
    if (steps_.size() < kMinSteps) return found;
    const double rotation = std::max(options_.minRotation, kOutlier * usual(steps_, rotationOf));
    const double shift = std::max(options_.minShift, kOutlier * usual(steps_, shiftOf));
    for (std::size_t i = kFewSteps; i + kFewSteps < steps_.size(); ++i) {
      const Jump& step = steps_[i];
      if (step.scan - step.before > kFewSteps) continue;
      const bool isTurned = rotationOf(step) >= rotation && isQuietAround(i, rotationOf);
      const bool isMoved = step.shift >= shift && isQuietAround(i, shiftOf);
      if (isTurned || isMoved) found.push_back(step);
    }
    return found;
  }

 private:
  bool isQuietAround(std::size_t i, double (*size)(const Jump&)) const {
    const std::size_t from = i - std::min(i, kFewSteps);
    const std::size_t to = std::min(steps_.size(), i + kFewSteps + 1);
    for (std::size_t k = from; k < to; ++k)
      if (k != i && size(steps_[k]) > size(steps_[i]) / 2) return false;
    return true;
  }

  const std::vector<Jump>& steps_;
  const FindBreaksOptions& options_;
};

}  // namespace

std::vector<ScanBreak> findBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                  const FindBreaksOptions& options) {
  const std::vector<Jump> steps = stepsOf(scans, track);
  std::vector<ScanBreak> breaks;
  for (const Jump& jump : JumpFinder(steps, options).find())
    breaks.push_back({jump.scan, jump.before, jump.scan, jump.rotation, jump.shift});
  const auto sharp = breaks;
  for (const ScanBreak& wide : findWideBreaks(scans, track, options))
    if (std::none_of(sharp.begin(), sharp.end(),
                     [&](const ScanBreak& known) { return areOne(known, wide); }))
      breaks.push_back(wide);
  std::sort(breaks.begin(), breaks.end(),
            [](const ScanBreak& l, const ScanBreak& r) { return l.scan < r.scan; });
  return breaks;
}

}  // namespace roomgraph
