#include "roomgraph/compare/Comparison.h"

#include <map>

namespace roomgraph {
namespace {

/** Runs that are joined by pairs that are sure: each by the name of one of them. */
class SureGroups {
 public:
  explicit SureGroups(const Comparison& comparison) {
    for (const ComparedPair& pair : comparison.pairs)
      if (pair.isSameSite && pair.confidence >= kSureConfidence)
        heads_[headOf(pair.a)] = headOf(pair.b);
    for (const ComparedRun& run : comparison.runs) ++sizes_[headOf(run.name)];
  }

  /** Whether no group of which it is not is larger. */
  bool isInLargest(const std::string& run) const {
    const std::size_t own = sizes_.at(headOf(run));
    for (const auto& [head, size] : sizes_)
      if (size > own) return false;
    return own > 1;
  }

 private:
  std::string headOf(std::string run) const {
    for (auto found = heads_.find(run); found != heads_.end() && found->second != run;
         found = heads_.find(run))
      run = found->second;
    return run;
  }

  std::map<std::string, std::string> heads_;
  std::map<std::string, std::size_t> sizes_;
};

}  // namespace

const char* certaintyText(Certainty certainty) {
  switch (certainty) {
    case Certainty::sure:
      return "sure";
    case Certainty::likely:
      return "likely";
    case Certainty::doubtful:
      return "doubtful";
    default:
      return "cannot tell";
  }
}

bool Comparison::isPlaceDoubtful(const std::string& run) const {
  bool hasPairs = false, isThere = false;
  for (const ComparedPair& pair : pairs)
    hasPairs = hasPairs || (pair.isSameSite && (pair.a == run || pair.b == run));
  for (const ComparedRun& one : runs) isThere = isThere || one.name == run;
  return hasPairs && isThere && !SureGroups(*this).isInLargest(run);
}

Certainty Comparison::certaintyOf(const ComparedRun& run) const {
  if (!run.score || !run.score->isMeaningful) return Certainty::cannotTell;
  if (isPlaceDoubtful(run.name)) return Certainty::doubtful;
  const RunScore& score = *run.score;
  const Measure* coverage = find(run.measures, "coverage");
  const bool isPartial =
      coverage && coverage->isMeaningful && coverage->value.value_or(1) < kPartialCoverage;
  const bool isWide = score.errorHigh > 2 * score.mapError + 0.1;
  return isPartial || isWide || score.share < kMostWalls ? Certainty::likely : Certainty::sure;
}

}  // namespace roomgraph
