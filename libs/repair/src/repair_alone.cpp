#include "roomgraph/repair/repair_alone.h"

#include "moved_run.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

/** Why a run is better left as it was; mended where nothing speaks for that. */
void judge(const RunCheck& check, RepairedRun& repaired) {
  if (!check.selfError) {
    repaired.reason = "left as it was: " + check.sentence;
  } else if (check.low <= 0) {
    repaired.reason =
        formatted("left as it was: its self error of %.3f m may be none", *check.selfError);
  } else if (!check.isConfirmed) {
    repaired.reason =
        "left as it was: what it saw twice does not bear out how its parts lie to each other";
  } else {
    repaired.state = RepairState::mended;
    repaired.reason = formatted("mended: it was %.3f m from agreeing with itself (%.3f to %.3f)",
                                *check.selfError, check.low, check.high);
  }
}

}  // namespace

RepairedRun repairAlone(const Run& run, const RunCheck& check) {
  RepairedRun repaired;
  repaired.poses = drawnPoses(run.scans);
  const std::vector<Transform2D> agreed = agreedPoses(check);
  std::vector<bool> isSeen;
  for (const CheckedPose& at : check.path) isSeen.push_back(at.isSeenTwice);
  repaired.frame = soundFrame(repaired.poses, agreed);
  repaired.unseen = unseenIn(run, isSeen);
  judge(check, repaired);
  if (repaired.state == RepairState::mended) moveTo(agreed, run, repaired);
  return repaired;
}

}  // namespace roomgraph
