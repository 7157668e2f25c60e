#include "roomgraph/align/align_maps.h"

#include <algorithm>
#include <tuple>

#include "fitted_align.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/refine_alignment.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

AlignmentCandidate candidateNear(const WallMap& a, const WallMap& b, const Transform2D& near,
                                 const Look& look) {
  AlignmentCandidate c;
  c.pose = refineAlignment(a, b, near, look);
  c.evidence = verifyAlignment(a, b, c.pose, look);
  c.score = alignmentScore(c.evidence);
  return c;
}

/** The best `count` of those that are not near a better one, improved; the best first. */
std::vector<AlignmentCandidate> lookedAt(const WallMap& a, const WallMap& b,
                                         const std::vector<AlignmentCandidate>& candidates,
                                         int count, const Look& look) {
  const auto areSame = [middle = b.middle()](const auto& l, const auto& r) {
    return areNear(l.pose, r.pose, middle, kSameStart);
  };
  std::vector<AlignmentCandidate> found;
  for (const AlignmentCandidate& c : distinctBest(candidates, std::size_t(count), areSame))
    found.push_back(candidateNear(a, b, c.pose, look));
  sortDownBy(found, &AlignmentCandidate::score);
  return found;
}

/** Any order that does not depend on which map was named first. */
bool isBefore(const WallMap& l, const WallMap& r) {
  const auto key = [](const WallMap& m) {
    return std::make_tuple(m.walls.size(), m.freeArea, m.frame.width, m.frame.height);
  };
  if (key(l) != key(r)) return key(l) > key(r);
  return std::lexicographical_compare(
      l.walls.begin(), l.walls.end(), r.walls.begin(), r.walls.end(),
      [](const WallPoint& p, const WallPoint& q) { return p.place < q.place; });
}

bool cannotBeToldApart(const WallMap& l, const WallMap& r) {
  return l.states == r.states && !isBefore(l, r) && !isBefore(r, l);
}

void judge(Alignment& result) {
  const double odds = sameSiteLogOdds(result.best->evidence);
  const double other = result.runnerUp ? sameSiteLogOdds(result.runnerUp->evidence) : -HUGE_VAL;
  const double margin = result.runnerUp ? result.best->score - result.runnerUp->score : HUGE_VAL;
  result.siteConfidence = probability(odds);
  result.isSameSite = result.siteConfidence >= fitted::kMinSameSite;
  result.isAmbiguous = result.isSameSite && isAmbiguousPose(other, margin);
  result.confidence = poseConfidence(odds, other, margin, result.best->evidence.weakest);
  if (!result.isSameSite) result.confidence = std::min(result.confidence, result.siteConfidence);
  result.runnerUpConfidence =
      result.runnerUp ? (1 - result.confidence) * probability(other - margin) : 0;
  result.overlap = result.best->evidence.overlap;
}

/** What follows from the poses that were looked at closely, best first. */
Alignment alignmentOf(const WallMap& a, const WallMap& b,
                      const std::vector<AlignmentCandidate>& found) {
  Alignment result;
  if (found.empty()) return result;
  result.best = found.front();
  const Point middle = b.middle();
  for (const AlignmentCandidate& c : found) {
    if (areNear(c.pose, result.best->pose, middle, kSameAnswer)) continue;
    result.runnerUp = c;
    break;
  }
  if (cannotBeToldApart(a, b) && areNear(result.best->pose, {}, middle, kSameStart))
    result.best->pose = {};
  judge(result);
  result.pose = result.best->pose;
  for (const AlignmentCandidate& c : found) result.poses.push_back(c.pose);
  result.poses.front() = result.pose;
  return result;
}

/** All poses that were looked at closely, best first; equal ones by the order of the search. */
std::vector<AlignmentCandidate> alignmentCandidates(const WallMap& a, const WallMap& b,
                                                    const SearchEffort& effort) {
  std::vector<AlignmentCandidate> found;
  for (const AlignmentHypothesis& h : alignmentHypotheses(a, b, effort))
    found.push_back(candidateNear(a, b, h.pose, kGlance));
  sortDownBy(found, &AlignmentCandidate::score);
  found = lookedAt(a, b, found, effort.closer, kSecondLook);
  return lookedAt(a, b, found, effort.close, kCloseLook);
}

}  // namespace

Alignment inverse(Alignment alignment) {
  alignment.pose = alignment.pose.inverse();
  for (Transform2D& pose : alignment.poses) pose = pose.inverse();
  if (alignment.best) alignment.best->pose = alignment.best->pose.inverse();
  if (alignment.runnerUp) alignment.runnerUp->pose = alignment.runnerUp->pose.inverse();
  return alignment;
}

Alignment alignMaps(const WallMap& a, const WallMap& b, const SearchEffort& effort) {
  if (!isBefore(b, a)) return alignmentOf(a, b, alignmentCandidates(a, b, effort));
  return inverse(alignmentOf(b, a, alignmentCandidates(b, a, effort)));
}

Alignment alignMapsNear(const WallMap& a, const WallMap& b, const std::vector<Transform2D>& poses) {
  std::vector<AlignmentCandidate> found;
  if (!a.walls.empty() && !b.walls.empty())
    for (const Transform2D& pose : poses) found.push_back(candidateNear(a, b, pose, kCloseLook));
  sortDownBy(found, &AlignmentCandidate::score);
  return alignmentOf(a, b, found);
}

}  // namespace roomgraph
