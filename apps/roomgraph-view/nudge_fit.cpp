#include "nudge_fit.h"

#include <algorithm>

#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/refine_alignment.h"

namespace roomgraph {
namespace {

/** The maps of the other run and of the one that is moved. */
struct TwoMaps {
  const WallMap *other, *moved;
  Transform2D otherPose, pose;  ///< other <- moved
};

std::optional<TwoMaps> twoMaps(const View& view, const ViewState& state) {
  const auto other = otherRun(view, state);
  if (!other) return std::nullopt;
  const Run* a = view.runNamed(view.comparison.runs[*other].name);
  const Run* b = view.runNamed(view.comparison.runs[state.run].name);
  if (!a || !b) return std::nullopt;
  const Transform2D& otherPose = view.comparison.runs[*other].pose;
  return TwoMaps{&a->map, &b->map, otherPose,
                 otherPose.inverse() * shownPose(view, state, state.run)};
}

}  // namespace

std::optional<NudgeFit> nudgeFit(const View& view, const ViewState& state) {
  const auto maps = twoMaps(view, state);
  if (!maps) return std::nullopt;
  const AlignmentEvidence evidence = verifyAlignment(*maps->other, *maps->moved, maps->pose);
  const double known = std::max(1e-9, evidence.known);
  return NudgeFit{evidence.overlap, std::min(1.0, evidence.loose / known),
                  std::min(1.0, evidence.contradicted / known), alignmentScore(evidence)};
}

void fitNudge(const View& view, ViewState& state) {
  const auto maps = twoMaps(view, state);
  if (state.mode != Mode::nudge || !maps) return;
  const Transform2D pose = refineAlignment(*maps->other, *maps->moved, maps->pose);
  state.nudge = maps->otherPose * pose * view.comparison.runs[state.run].pose.inverse();
}

}  // namespace roomgraph
