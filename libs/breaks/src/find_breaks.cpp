#include "roomgraph/breaks/find_breaks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fitted_breaks.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

double rotationOf(const ScanBreak& at) { return std::abs(at.rotation); }
double shiftOf(const ScanBreak& at) { return at.shift; }

/** Whether two breaks begin or end within a few scans of each other. */
bool areOne(const ScanBreak& l, const ScanBreak& r) {
  return l.before <= r.behind + fitted::kFewSteps && r.before <= l.behind + fitted::kFewSteps;
}

void addUnlessKnown(const ScanBreak& found, std::vector<ScanBreak>& breaks) {
  if (!anyOf(breaks, [&](const ScanBreak& known) { return areOne(known, found); }))
    breaks.push_back(found);
}

class BreakFinder {
 public:
  BreakFinder(const std::vector<ScanWalls>& scans, const ScanTrack& track,
              const FindBreaksOptions& options)
      : scans_(scans), track_(track), options_(options) {
    for (std::size_t k = 1; k < track.size(); ++k) steps_.push_back(change(k - 1, k));
  }

  /** Those that stand out of the other steps. */
  std::vector<ScanBreak> sharp() const {
    std::vector<ScanBreak> found;
    if (steps_.size() < fitted::kMinSteps) return found;
    const double rotation = std::max(options_.minRotation, fitted::kOutlier * usual(rotationOf));
    const double shift = std::max(options_.minShift, fitted::kOutlier * usual(shiftOf));
    for (std::size_t i = fitted::kFewSteps; i + fitted::kFewSteps < steps_.size(); ++i) {
      const ScanBreak& step = steps_[i];
      const bool isTurned = rotationOf(step) >= rotation && isQuietAround(i, rotationOf);
      const bool isMoved = step.shift >= shift && isQuietAround(i, shiftOf);
      if (isTurned || isMoved) found.push_back(step);
    }
    return found;
  }

  /** Those that turn or shift too far for any noise, in one step or in a few, and stay so: at least
   *  kApartRotation or kApartShift. Of those that are one only the sharpest. */
  std::vector<ScanBreak> wide() const {
    std::vector<std::pair<double, ScanBreak>> all;  // by sharpness
    for (std::size_t from = fitted::kFewSteps; from + fitted::kFewSteps < track_.size(); ++from)
      for (std::size_t to = from + 1;
           to <= from + fitted::kFewSteps && to + fitted::kFewSteps < track_.size(); ++to) {
        const ScanBreak at = between(from, to);
        const double size = sizeOf(at);
        if (size >= 1 && sizeOf(between(from, to + fitted::kFewSteps)) >= size / 2 &&
            sizeOf(between(from - fitted::kFewSteps, to)) >= size / 2)
          all.emplace_back(size / std::sqrt(double(to - from)), at);
      }
    sortDownBy(all, [](const auto& one) { return one.first; });
    std::vector<ScanBreak> kept;
    for (const auto& [sharpness, at] : all) addUnlessKnown(at, kept);
    return kept;
  }

 private:
  /** What the run turns and shifts too far from one scan to another: the map shows its error the
   *  other way round. */
  ScanBreak change(std::size_t before, std::size_t behind) const {
    const Transform2D &from = track_[before], &to = track_[behind];
    const Point place = scans_[behind].robot();
    return {behind, before, behind, wrappedAngle(from.phi - to.phi),
            distance(from(place), to(place))};
  }

  /** The same over several steps, at the largest of them. */
  ScanBreak between(std::size_t from, std::size_t to) const {
    ScanBreak all = change(from, to);
    double most = -1;
    for (std::size_t i = from; i < to; ++i)
      if (const double size = sizeOf(steps_[i]); size > most) most = size, all.scan = i + 1;
    return all;
  }

  double sizeOf(const ScanBreak& at) const {
    return std::max(rotationOf(at) / std::max(kApartRotation, options_.minRotation),
                    at.shift / std::max(kApartShift, options_.minShift));
  }

  double usual(double (*size)(const ScanBreak&)) const {
    return quantile(mapped(steps_, size), 0.95);
  }

  bool isQuietAround(std::size_t i, double (*size)(const ScanBreak&)) const {
    for (std::size_t k = i - fitted::kFewSteps; k <= i + fitted::kFewSteps; ++k)
      if (k != i && size(steps_[k]) > size(steps_[i]) / 2) return false;
    return true;
  }

  const std::vector<ScanWalls>& scans_;
  const ScanTrack& track_;
  const FindBreaksOptions& options_;
  std::vector<ScanBreak> steps_;  // to each scan but the first
};

}  // namespace

std::vector<ScanBreak> findBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                  const FindBreaksOptions& options) {
  const BreakFinder finder(scans, track, options);
  std::vector<ScanBreak> breaks = finder.sharp();
  for (const ScanBreak& wide : finder.wide()) addUnlessKnown(wide, breaks);
  sortBy(breaks, &ScanBreak::scan);
  return breaks;
}

}  // namespace roomgraph
