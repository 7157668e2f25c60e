#pragma once
#include <optional>
#include <vector>

#include "roomgraph/consensus/scans_of_step.h"

namespace roomgraph {

// In:   the scans of a run, and where the run has drawn them
// Out:  whether they refute, or prefer, another step
// Next: ownMatches, rejoinPieces, siteBreaks, checkRun

/** What refutes a step: walls that stand where scans see free space, or also that the robot makes
 *  no such steps, which says nothing of where along a corridor a scan lies. */
enum class RefutedBy { walls, wallsOrGait };

/** What the scans on both sides of a step of a run say of another one in its place. Keeps
 *  references to the scans and to where they were drawn. A step goes from scan k - 1 to scan k, of
 *  at least 1. O(scans) to make; O(cells around a few scans) for each step. */
class StepWitness {
 public:
  StepWitness(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn);
  StepWitness(const StepWitness&) = delete;  // of a member: what it refers to would be another's
  StepWitness& operator=(const StepWitness&) = delete;

  /** Whether the scans agree with the step to scan `k` as it was drawn, and either clearly less
   *  with `step` (scan k - 1 <- scan k), where walls stand in a place that they see as free, or the
   *  robot makes no such steps. False where either is a guess. */
  bool refutes(std::size_t k, const Transform2D& step, RefutedBy by = RefutedBy::wallsOrGait);

  /** Whether they fit clearly better with `step` than as it was drawn. */
  bool prefers(std::size_t k, const Transform2D& step);

 private:
  struct Fits {
    ScanFit drawn, other;
  };
  std::optional<Fits> fitsOf(std::size_t k, const Transform2D& step);

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& drawn_;
  Gait gait_;
  ScansOfStep sides_;
};

}  // namespace roomgraph
