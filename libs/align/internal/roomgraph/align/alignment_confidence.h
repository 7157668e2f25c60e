#pragma once
#include "roomgraph/align/verify_alignment.h"

namespace roomgraph {

// In:   the evidence for a pose
// Out:  how much it is worth
// Next: alignMaps

/** Confidence of an alignment from which on nothing else is asked; less is worth a look. */
constexpr double kSureConfidence = 0.9;

/** Ranks the poses of one pair: grows with the length of wall that is found again, and falls with
 *  the shares of it that are contradicted. Differences are about log odds; the number alone says
 *  nothing. */
double alignmentScore(const AlignmentEvidence& evidence);

/** The log odds that two maps show the same building, from the evidence for the best pose; between
 *  -6 and 6. Fitted by logistic regression (inputs scaled to unit variance, L2 penalty 10) on the
 *  781 pairs that benchmarks/alignment_accuracy writes with --features: 268 of runs of one
 *  building, 165 of these cut to overlaps of 40, 25 and 15 %, and 348 of different buildings. */
double sameSiteLogOdds(const AlignmentEvidence& evidence);

/** The probability that the best pose is right, from the log odds of the best pose and of the
 *  runner-up, from how much the scores differ (0 or more), and from how many metres of wall hold
 *  the best pose in its weakest direction: along a hall without ends it slides, however well its
 *  walls fit. Fitted on the same pairs. A pair without a runner-up is one with a very bad one. */
double poseConfidence(double bestLogOdds, double runnerUpLogOdds, double scoreMargin,
                      double weakest);

/** Whether the runner-up could as well be the right pose. */
bool isAmbiguousPose(double runnerUpLogOdds, double scoreMargin);

/** 1 / (1 + exp(-logOdds)). */
double probability(double logOdds);

}  // namespace roomgraph
