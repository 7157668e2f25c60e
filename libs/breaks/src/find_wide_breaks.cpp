#include "find_wide_breaks.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

/** Looks at all stretches of a few steps. */
class WideBreaks {
 public:
  WideBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
             const FindBreaksOptions& options)
      : scans_(scans), track_(track), options_(options) {
    for (std::size_t k = 0; k < track.size(); ++k)
      if (track[k]) found_.push_back(k);
  }

  /** The sharpest first. */
  std::vector<ScanBreak> find() const {
    auto all = candidates();
    std::stable_sort(all.begin(), all.end(), [](const Candidate& l, const Candidate& r) {
      return l.sharpness > r.sharpness;
    });
    std::vector<ScanBreak> kept;
    for (const Candidate& each : all)
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const ScanBreak& other) { return areOne(other, each.at); }))
        kept.push_back(each.at);
    return kept;
  }

 private:
  struct Candidate {
    ScanBreak at;
    double sharpness = 0;
  };

  std::vector<Candidate> candidates() const {
    std::vector<Candidate> all;
    for (std::size_t from = kFewSteps; from + kFewSteps < found_.size(); ++from)
      for (std::size_t to = from + 1; to <= from + kFewSteps && to + kFewSteps < found_.size();
           ++to) {
        const ScanBreak at = between(from, to);
        const double size = sizeOf(at);
        if (size < 1 || sizeOf(between(from, to + kFewSteps)) < size / 2 ||
            sizeOf(between(from - kFewSteps, to)) < size / 2)
          continue;
        all.push_back({at, size / std::sqrt(double(to - from))});
      }
    return all;
  }

  /** What the run turns and shifts too far between two scans that were found. */
  ScanBreak between(std::size_t from, std::size_t to) const {
    const std::size_t before = found_[from], behind = found_[to];
    std::size_t largest = behind;
    double most = -1;
    for (std::size_t i = from + 1; i <= to; ++i) {
      const double size = sizeOf(change(found_[i - 1], found_[i]));
      if (size > most) most = size, largest = found_[i];
    }
    ScanBreak all = change(before, behind);
    all.scan = largest;
    return all;
  }

  ScanBreak change(std::size_t before, std::size_t behind) const {
    const Transform2D &from = *track_[before], &to = *track_[behind];
    const Point place = scans_[behind].robot();
    return {behind, before, behind, wrappedAngle(from.phi - to.phi),
            distance(from(place), to(place))};
  }

  double sizeOf(const ScanBreak& at) const {
    return std::max(std::abs(at.rotation) / std::max(kApartRotation, options_.minRotation),
                    at.shift / std::max(kApartShift, options_.minShift));
  }

  const std::vector<ScanWalls>& scans_;
  const ScanTrack& track_;
  const FindBreaksOptions& options_;
  std::vector<std::size_t> found_;
};

}  // namespace

bool areOne(const ScanBreak& l, const ScanBreak& r) {
  return l.before <= r.behind + kFewSteps && r.before <= l.behind + kFewSteps;
}

std::vector<ScanBreak> findWideBreaks(const std::vector<ScanWalls>& scans, const ScanTrack& track,
                                      const FindBreaksOptions& options) {
  return WideBreaks(scans, track, options).find();
}

}  // namespace roomgraph
