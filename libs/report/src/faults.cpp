#include "roomgraph/report/faults.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/report/run_check_json.h"

namespace roomgraph {
namespace {

constexpr std::size_t kFramesBeside = 10;  // scans that are shown on either side of a fault

/** The place in a path of the first scan from a key frame on; none behind its end. */
template <class Path>
std::optional<std::size_t> scanFrom(std::size_t keyFrame, const Path& path) {
  const auto* found = findIf(path, [&](const auto& at) { return at.keyFrame >= keyFrame; });
  return found ? std::optional(std::size_t(found - path.data())) : std::nullopt;
}

/** A break that says nothing of itself yet; `path` is that of its run. */
template <class Path>
Fault faultAt(const MapBreak& tear, const Path& path) {
  Fault fault;
  fault.run = tear.run, fault.place = tear.place, fault.keyFrame = tear.keyFrame;
  if (tear.torn) fault.mend = tear.torn->mend();
  const auto behind = tear.keyFrame ? scanFrom(*tear.keyFrame, path) : std::nullopt;
  if (!behind) return fault;
  const std::size_t first = *behind - std::min(*behind, kFramesBeside),
                    end = std::min(path.size(), *behind + kFramesBeside);
  if (first < *behind) fault.earlier = {path[first].keyFrame, path[*behind - 1].keyFrame};
  fault.later = {path[*behind].keyFrame, path[end - 1].keyFrame};
  return fault;
}

/** The scans beside the one at which a stretch is shown. */
KeyFrames framesOf(const DrawnStretch& stretch, const std::vector<CheckedPose>& path) {
  const auto scan = scanFrom(stretch.keyFrame, path);
  if (!scan) return {};
  return {path[*scan - std::min(*scan, kFramesBeside)].keyFrame,
          path[std::min(path.size() - 1, *scan + kFramesBeside)].keyFrame};
}

Fault faultOf(FaultKind kind, const DrawnStretch& one, const DrawnStretch& other,
              const RunCheck& check) {
  Fault fault;
  fault.kind = kind;
  fault.run = check.name, fault.place = one.place, fault.keyFrame = other.keyFrame;
  fault.earlier = framesOf(one, check.path), fault.later = framesOf(other, check.path);
  return fault;
}

}  // namespace

std::vector<Fault> faultsOf(const Comparison& comparison) {
  std::vector<Fault> faults;
  for (const MapBreak& tear : comparison.breaks) {
    const ComparedRun* run = findRun(comparison.runs, tear.run);
    Fault fault = faultAt(tear, run ? run->path : std::vector<PathPose>());
    fault.number = faults.size() + 1;
    fault.text = formatted("everything after it is turned by %.1f degrees, shifted by %.2f m",
                           tear.rotation * 180 / M_PI, tear.shift);
    faults.push_back(std::move(fault));
  }
  return faults;
}

std::vector<Fault> faultsOf(const RunCheck& check) {
  std::vector<Fault> faults;
  std::map<FaultKind, std::size_t> numbers;
  const auto add = [&](Fault fault, const std::string& text) {
    fault.number = ++numbers[fault.kind], fault.text = text;
    faults.push_back(std::move(fault));
  };
  for (const MapBreak& tear : check.breaks) add(faultAt(tear, check.path), selfBreakText(tear));
  for (const DoubledPlace& place : check.doubled) {
    add(faultOf(FaultKind::doubled, place.one, place.other, check), doubledText(place));
    faults.back().mend = place.mend;
  }
  for (const WeldedPlace& place : check.welded)
    add(faultOf(FaultKind::welded, place.one, place.other, check), weldedText(place));
  return faults;
}

}  // namespace roomgraph
