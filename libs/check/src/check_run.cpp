#include "roomgraph/check/check_run.h"

#include <algorithm>
#include <cmath>

#include "find_doubled.h"
#include "fitted_check.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/check/beams_through_walls.h"
#include "roomgraph/consensus/StepWitness.h"
#include "roomgraph/consensus/mend_steps.h"
#include "self_consensus.h"
#include "self_evidence.h"

namespace roomgraph {
namespace {

/** Of steps that were drawn wrong, by how much nothing tells, the first of each series; without
 *  those next to a step that is known to be broken. */
std::vector<std::size_t> lostSteps(const std::vector<StepEvidence>& evidence,
                                   const std::vector<std::size_t>& broken) {
  std::vector<std::size_t> lost;
  for (std::size_t k = 1; k < evidence.size(); ++k)
    if (evidence[k] == StepEvidence::lost && evidence[k - 1] != StepEvidence::lost &&
        !anyOf(broken, [&](std::size_t other) {
          return std::max(k, other) - std::min(k, other) <= fitted::kSeenBeside;
        }))
      lost.push_back(k);
  return lost;
}

MapBreak lostAt(std::size_t k, const Run& run) {
  MapBreak tear;
  tear.run = run.name;
  tear.place = run.scans[k - 1].robot();
  tear.keyFrame = run.scans[k].keyFrame, tear.time = run.scans[k].time;
  return tear;
}

Transform2D stepTo(std::size_t k, const std::vector<Transform2D>& poses) {
  return poses[k - 1].inverse() * poses[k];
}

/** By how much the step to a scan was drawn otherwise than is agreed. */
MapBreak breakAt(std::size_t k, const Run& run, const std::vector<Transform2D>& drawn,
                 const std::vector<Transform2D>& agreed) {
  const Transform2D step = stepTo(k, drawn), right = stepTo(k, agreed);
  MapBreak tear = lostAt(k, run);
  tear.rotation = wrappedAngle(step.phi - right.phi);
  tear.shift = distance(step.shift(), right.shift());
  tear.torn = TornPose{drawn[k], drawn[k - 1] * right};
  return tear;
}

/** The breaks of a run, what else it has drawn wrong, and whether that is confirmed. Where a run
 *  bends little by little, the consensus lets single steps give way. These are no breaks if the
 *  scans on both sides hold them as they were drawn. */
void addFaults(const Run& run, const std::vector<LocalScan>& scans, const MendedSteps& mended,
               const SelfConsensus& agreed, RunCheck& check) {
  const std::vector<Transform2D> drawn = drawnPoses(run.scans);
  StepWitness witness(scans, drawn);
  std::vector<std::size_t> broken;
  for (std::size_t k = 1; k < run.scans.size(); ++k) {
    const MapBreak step = breakAt(k, run, drawn, agreed.poses);
    if (step.kind() == BreakClass::slight) continue;
    broken.push_back(k);
    if (mended.evidence[k] != StepEvidence::agrees || !witness.refutes(k, stepTo(k, agreed.poses)))
      check.breaks.push_back(step);
  }
  sortDownBy(check.breaks, &MapBreak::size);
  const std::vector<std::size_t> lost = lostSteps(mended.evidence, broken);
  for (const std::size_t k : lost) check.breaks.push_back(lostAt(k, run));
  broken.insert(broken.end(), lost.begin(), lost.end());
  check.isConfirmed = isConfirmed(agreed, broken);
  check.doubled = findDoubled(run, agreed, broken);
}

/** Whether a scan was found again, or one of those beside it, which see the same walls. */
bool isSeenBeside(const std::vector<bool>& isSeen, std::size_t k) {
  const auto first = isSeen.begin() + std::ptrdiff_t(k - std::min(k, fitted::kSeenBeside));
  const auto end =
      isSeen.begin() + std::ptrdiff_t(std::min(isSeen.size(), k + fitted::kSeenBeside + 1));
  return std::find(first, end, true) != end;
}

/** The share of the path that lies at scans that were seen twice. */
double shareOfPath(const std::vector<CheckedPose>& path) {
  double seen = 0, all = 0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double way = distance(path[k - 1].pose.shift(), path[k].pose.shift());
    all += way;
    if (path[k].isSeenTwice) seen += way;
  }
  return all > 0 ? seen / all : 0;
}

/** Whether so many steps break that the scanner is at fault, and not the map. */
bool isScannerWrong(const RunCheck& check) {
  return double(check.breaks.size()) > fitted::kMostBroken * double(check.path.size());
}

std::string sentenceOf(const RunCheck& check, bool isRefuted) {
  const double percent = 100 * check.seenTwice;
  if (isScannerWrong(check))
    return formatted(
        "cannot tell: %zu of its %zu steps contradict its scans, as if the clock of the scanner "
        "were late, or the scanner not mounted as the run says",
        check.breaks.size(), check.path.size() - 1);
  if (!check.selfError && !check.welded.empty())
    return formatted(
        "cannot tell: key frames %zu and %zu are drawn at one place, but see through each other's "
        "walls, so they are probably in two places",
        check.welded.front().one.keyFrame, check.welded.front().other.keyFrame);
  if (!check.selfError && isRefuted)
    return "cannot tell: if it agreed with itself, its beams would pass through more of its own "
           "walls than they do now";
  if (!check.selfError && !check.breaks.empty())
    return formatted(
        "cannot tell: the run breaks before key frame %zu, and too little was seen from both sides "
        "of its breaks to say how its parts lie to each other",
        *check.breaks.front().keyFrame);
  if (!check.selfError && check.seenTwice > fitted::kLeastSeenTwice)
    return formatted(
        "cannot tell: %.0f %% of its path was seen twice, and these revisits contradict each other",
        percent);
  if (!check.selfError)
    return formatted("cannot tell: %.0f %% of its path was seen twice", percent);
  const bool isSound = *check.selfError < kBreakShift && check.breaks.empty() &&
                       check.doubled.empty() && check.welded.empty();
  return formatted(
      "%s %.2f m where it was seen twice (%.0f %% of its path); nothing is known of slow bends in "
      "the %.0f %% that was driven once, nor of errors that all passes share",
      isSound ? "agrees with itself within" : "contradicts itself by", *check.selfError, percent,
      100 - percent);
}

/** Of a run without scans. */
std::string sentenceOf(const WallMap& map) {
  std::string text = "cannot tell: it has no scans";
  if (map.wallDoubling && map.axisDeviation)
    text += formatted(
        ", and its map alone says little: %.0f %% of its walls stand in front of another that "
        "faces the same way (up to 25 %% in sound maps), and half of them are off right angles by "
        "%.1f degrees or more; furniture and slanted walls look the same",
        100 * *map.wallDoubling, *map.axisDeviation * 180 / M_PI);
  return text;
}

}  // namespace

std::vector<std::string> complaintsOf(const RunCheck& check, const CheckGateOptions& options) {
  std::vector<std::string> complaints;
  const bool isUnknown =
      (options.maxError && !check.selfError) ||
      ((options.failsOnBreaks || options.failsOnDoubled) && check.path.size() < 2);
  if (isUnknown)
    complaints.push_back(check.sentence);
  else if (options.maxError && *check.selfError > *options.maxError)
    complaints.push_back(
        formatted("its self error of %.3f m is above %g m", *check.selfError, *options.maxError));
  if (options.failsOnBreaks && !check.breaks.empty())
    complaints.push_back("it breaks in " + counted(check.breaks.size(), "place", "places"));
  if (options.failsOnDoubled && !check.doubled.empty())
    complaints.push_back("it has drawn " + counted(check.doubled.size(), "place", "places") +
                         " twice");
  if (options.failsOnDoubled && !check.welded.empty())
    complaints.push_back("it has laid " + counted(check.welded.size(), "place", "places") +
                         " over another");
  return complaints;
}

RunCheck checkRun(const Run& run) {
  RunCheck check;
  check.name = run.name, check.file = run.file, check.sha256 = run.sha256;
  if (run.scans.empty()) {
    check.sentence = sentenceOf(run.map), check.evidence = mapEvidence(run);
    return check;
  }
  const std::vector<LocalScan> scans = localScans(run.scans);
  const MendedSteps mended = mendSteps(scans, drawnPoses(run.scans));
  const SelfConsensus agreed = selfConsensus(run, scans, mended);
  for (std::size_t k = 0; k < run.scans.size(); ++k)
    check.path.push_back({run.scans[k].keyFrame, run.scans[k].time, run.scans[k].pose,
                          agreed.poses[k], agreed.error.errors[k],
                          isSeenBeside(agreed.error.isSeen, k)});
  check.seenTwice = shareOfPath(check.path);
  addFaults(run, scans, mended, agreed, check);
  const BeamsThroughWalls beams = beamsThroughWalls(scans, drawnPoses(run.scans));
  const BeamsThroughWalls agreedBeams = beamsThroughWalls(scans, agreed.poses);
  check.welded = findWelded(run, beams, agreedBeams);
  check.evidence = selfEvidence(run, mended, agreed, beams, agreedBeams);
  // It has not parted what cannot be one place, so that nothing says how far it is off.
  const bool isBlind = !check.welded.empty() && agreed.error.error < kBreakShift;
  const bool isRefuted = agreed.error.low > 0 && seesThroughMore(beams, agreedBeams);
  if (check.isConfirmed && !isBlind && !isRefuted && !isScannerWrong(check) &&
      (check.seenTwice > fitted::kLeastSeenTwice || !check.breaks.empty())) {
    check.selfError = agreed.error.error;
    check.low = agreed.error.low, check.high = agreed.error.high;
  }
  check.sentence = sentenceOf(check, isRefuted);
  return check;
}

}  // namespace roomgraph
