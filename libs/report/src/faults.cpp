#include "roomgraph/report/faults.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/breaks/frames_at_break.h"
#include "roomgraph/relate/Run.h"
#include "roomgraph/report/run_check_json.h"

namespace roomgraph {
namespace {

/** A break that says nothing of itself yet; `path` is that of its run. */
template <class Path>
Fault faultAt(const MapBreak& tear, const Path& path) {
  Fault fault;
  fault.run = tear.run, fault.place = tear.place, fault.keyFrame = tear.keyFrame;
  if (tear.torn) fault.mend = tear.torn->mend();
  const FramesAtBreak frames = framesAtBreak(tear, path);
  if (frames.first < frames.behind)
    fault.earlier = {path[frames.first].keyFrame, path[frames.behind - 1].keyFrame};
  if (frames.behind < frames.end)
    fault.later = {path[frames.behind].keyFrame, path[frames.end - 1].keyFrame};
  return fault;
}

/** The scans beside the one at which a stretch is shown. */
KeyFrameRange framesOf(const DrawnStretch& stretch, const std::vector<CheckedPose>& path) {
  const auto found = std::find_if(path.begin(), path.end(), [&](const CheckedPose& pose) {
    return pose.keyFrame >= stretch.keyFrame;
  });
  if (found == path.end()) return {};
  const auto scan = std::size_t(found - path.begin());
  return {path[scan - std::min(scan, kFramesAtBreak)].keyFrame,
          path[std::min(path.size() - 1, scan + kFramesAtBreak)].keyFrame};
}

Fault faultOf(const DrawnStretch& one, const DrawnStretch& other, const RunCheck& check) {
  Fault fault;
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
  for (std::size_t i = 0; i < check.breaks.size(); ++i) {
    faults.push_back(faultAt(check.breaks[i], check.path));
    faults.back().number = i + 1, faults.back().text = selfBreakText(check.breaks[i]);
  }
  for (std::size_t i = 0; i < check.doubled.size(); ++i) {
    const DoubledPlace& place = check.doubled[i];
    faults.push_back(faultOf(place.one, place.other, check));
    faults.back().kind = FaultKind::doubled, faults.back().mend = place.mend;
    faults.back().number = i + 1, faults.back().text = doubledText(place);
  }
  for (std::size_t i = 0; i < check.welded.size(); ++i) {
    const WeldedPlace& place = check.welded[i];
    faults.push_back(faultOf(place.one, place.other, check));
    faults.back().kind = FaultKind::welded;
    faults.back().number = i + 1, faults.back().text = weldedText(place);
  }
  return faults;
}

}  // namespace roomgraph
