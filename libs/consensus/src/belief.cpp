#include "belief.h"

#include <algorithm>
#include <cmath>

#include "fitted_consensus.h"

namespace roomgraph {

bool isBorneOut(const SubmapMatch& match, const Transform2D& in, const Transform2D& of,
                const PoseTolerance& within) {
  return isBorneOut(match, in.inverse() * of, within);
}

bool isBorneOut(const SubmapMatch& match, const Transform2D& found, const PoseTolerance& within) {
  return match.isSameScan || (std::abs(wrappedAngle(found.phi - match.pose.phi)) < within.turn &&
                              distance(found.shift(), match.pose.shift()) < within.place);
}

double beliefOf(double share) {
  constexpr double kLeast = 1e-3;  // so that a piece can come back
  return std::max(kLeast, share * share);
}

double costOfGivingUp(const RunMatches& piece) {
  return fitted::kGivingUp * std::sqrt(double(piece.matches.size()) / fitted::kGivingUpMatches) *
         std::clamp((fitted::kAlikeTo - piece.likeness) / (fitted::kAlikeTo - fitted::kAlikeFrom),
                    fitted::kLeastCost, 1.0);
}

std::vector<double> beliefIn(const std::vector<RunMatches>& matches, const SubmapPoses& poses,
                             const PoseTolerance& within) {
  std::vector<double> belief;
  for (const RunMatches& piece : matches) {
    double borneOut = 0;
    for (const SubmapMatch& match : piece.matches)
      borneOut +=
          isBorneOut(match, poses[piece.in][match.in], poses[piece.of][match.submap], within);
    belief.push_back(beliefOf(borneOut / double(piece.matches.size())));
  }
  return belief;
}

double costOfDisbelief(const std::vector<RunMatches>& matches, const std::vector<double>& belief) {
  double cost = 0;
  for (std::size_t m = 0; m < matches.size(); ++m)
    cost += costOfGivingUp(matches[m]) * (1 - belief[m]);
  return cost;
}

}  // namespace roomgraph
