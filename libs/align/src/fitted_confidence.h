#pragma once

/** Fitted by logistic regression: benchmarks/fit_confidence prints these from the pairs that
 *  benchmarks/alignment_accuracy writes with --features. An intercept first, then the weights. */
namespace roomgraph::fitted {

/** Of what sameSiteLogOdds looks at, in its order. */
constexpr double kSameSite[] = {-4.307, 0.255, -0.787, -0.252, -0.212, 2.057,
                                0.303,  0.599, 0.791,  -5.394, -4.561};

/** Of what poseConfidence looks at, in its order. */
constexpr double kRightPose[] = {-0.956, 0.575, 1.432, 0.242, -1.111};

}  // namespace roomgraph::fitted
