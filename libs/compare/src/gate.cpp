#include "roomgraph/compare/gate.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

constexpr std::size_t kBest = 3;  // runs that a new one is held against

std::string breakText(const MapBreak& found) {
  return formatted("is broken at (%.1f, %.1f) by %.1f degrees and %.2f m", found.place.x,
                   found.place.y, found.rotation * 180 / M_PI, found.shift);
}

std::string coverageText() {
  const int percent = int(std::lround(100 * kPartialCoverage));
  return "has seen less than " + std::to_string(percent) + " % of what two runs have seen";
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<double> trustedError(const ComparedRun& run) {
  if (!run.score || !run.score->isMeaningful) return {};
  return run.score->mapError;
}

class Judge {
 public:
  Judge(const Comparison& comparison, const GateOptions& options)
      : comparison_(comparison), options_(options) {}

  GateVerdict verdict() {
    std::size_t judged = 0;
    for (const ComparedRun& run : comparison_.runs) {
      if (run.name == comparison_.reference || !isJudged(run.name)) continue;
      ++judged;
      judgeScore(run);
      judgeError(run);
      const Measure* coverage = find(run.measures, "coverage");
      if (options_.failsOnCoverage && coverage && coverage->value.value_or(0) < kPartialCoverage)
        complain(run.name, coverageText());
    }
    for (const MapBreak& found : comparison_.breaks)
      if (options_.failsOnBreaks && isJudged(found.run)) complain(found.run, breakText(found));
    for (const LeftOutRun& run : comparison_.leftOut)
      if (isJudged(run.name)) judgeLeftOut(run);
    if (judged == 0 && lines_.empty()) lines_.push_back("no run is left to be judged");
    return {lines_, options_.candidates, asked()};
  }

 private:
  bool isJudged(const std::string& run) const {
    return options_.candidates.empty() || contains(options_.candidates, run);
  }
  bool needsError() const {
    return options_.maxError || options_.maxWorse || !options_.candidates.empty();
  }
  void complain(const std::string& run, const std::string& what) {
    lines_.push_back(run + ": " + what);
  }

  void judgeScore(const ComparedRun& run) {
    if (options_.minScore && !run.score) complain(run.name, "has no score");
    if (options_.minScore && run.score && run.score->score < *options_.minScore)
      complain(run.name, "its score is below --fail-below");
  }

  void judgeError(const ComparedRun& run) {
    if (!needsError()) return;
    const auto error = trustedError(run);
    if (!error) return complain(run.name, "its map error cannot be told: too little to compare");
    if (options_.maxError && *error > *options_.maxError)
      complain(run.name, "its map error of " + formatted("%.3f m", *error) + " is above " +
                             formatted("%.3f m", *options_.maxError));
    if (!options_.maxWorse) return;
    const auto record = recordError(comparison_, run.name, options_.candidates);
    if (!record) return complain(run.name, "there is no other run to hold it against");
    if (*error - *record > *options_.maxWorse)
      complain(run.name, "its map error of " + formatted("%.3f m", *error) + " is " +
                             formatted("%.3f m", *error - *record) +
                             " more than the median of the three best others, so more than " +
                             formatted("%.3f m", *options_.maxWorse));
  }

  void judgeLeftOut(const LeftOutRun& run) {
    if (options_.minScore) complain(run.name, "has no score");
    if (run.isOtherSite && options_.failsOnOtherSites)
      complain(run.name, "is not of the same site");
    else if (needsError())
      complain(run.name, run.isOtherSite ? "is not of the same site" : "could not be read");
  }

  std::vector<std::string> asked() const {
    std::vector<std::string> lines;
    if (options_.minScore)
      lines.push_back(formatted("a score of %.4g at least", *options_.minScore));
    if (options_.maxError)
      lines.push_back(formatted("a map error of %.4g m at most", *options_.maxError));
    if (options_.maxWorse)
      lines.push_back(
          formatted("at most %.4g m more map error than the median of the three best others",
                    *options_.maxWorse));
    if (options_.failsOnCoverage) lines.push_back("enough coverage");
    if (options_.failsOnBreaks) lines.push_back("no break");
    if (options_.failsOnOtherSites) lines.push_back("the same site");
    if (lines.empty()) lines.push_back("a map error that can be told");
    return lines;
  }

  const Comparison& comparison_;
  const GateOptions& options_;
  std::vector<std::string> lines_;
};

}  // namespace

GateVerdict gateVerdict(const Comparison& comparison, const GateOptions& options) {
  if (options.asksNothing()) return {};
  return Judge(comparison, options).verdict();
}

std::optional<double> recordError(const Comparison& comparison, const std::string& run,
                                  const std::vector<std::string>& candidates) {
  std::vector<double> errors;
  for (const ComparedRun& other : comparison.runs) {
    if (other.name == run || other.name == comparison.reference) continue;
    const auto error = contains(candidates, other.name) ? std::nullopt : trustedError(other);
    if (error) errors.push_back(*error);
  }
  if (errors.empty()) return {};
  std::sort(errors.begin(), errors.end());
  errors.resize(std::min(kBest, errors.size()));
  return median(errors);
}

}  // namespace roomgraph
