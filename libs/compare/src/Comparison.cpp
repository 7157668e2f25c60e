#include "roomgraph/compare/Comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/check/find_refuted.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {
namespace {

using Names = std::vector<std::string>;

/** The runs in sets that pairs join, each run's name among those of one set. */
template <class IsJoined>
std::vector<Names> setsOf(const std::vector<ComparedPair>& pairs, const IsJoined& isJoined) {
  std::map<std::string, std::uint32_t> places;
  for (const ComparedPair& pair : pairs)
    if (isJoined(pair)) places[pair.a], places[pair.b];
  std::uint32_t count = 0;
  for (auto& [name, place] : places) place = count++;
  UnionFind groups(count);
  for (const ComparedPair& pair : pairs)
    if (isJoined(pair)) groups.join(places[pair.a], places[pair.b]);
  std::map<std::uint32_t, Names> sets;
  for (const auto& [name, place] : places) sets[groups.find(place)].push_back(name);
  std::vector<Names> names;
  for (auto& [group, set] : sets) names.push_back(std::move(set));
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::optional<double> ComparedRun::partialCoverage() const {
  const auto coverage = trustedValueOf(measures, "coverage");
  return coverage.value_or(1) < kNearlyAll ? coverage : std::nullopt;
}

std::string ComparedRun::unconfirmedFault() const {
  if (welded) return weldedText(*welded);
  if (!score) return "";
  return roomgraph::unconfirmedFault(score->confirmed, score->contradicted,
                                     trustedValueOf(measures, "coverage").value_or(1));
}

const Measure* ComparedRun::addedWalls() const {
  for (const auto& [measure, most] : {std::pair("straight_walls_added", kMostStraightAdded),
                                      std::pair("walls_added", kMostAdded)}) {
    const Measure* added = find(measures, measure);
    if (added && added->isMeaningful && added->place && *added->value > most) return added;
  }
  return nullptr;
}

bool ComparedRun::isPlaceBorneOut() const {
  return score && !path.empty() && score->others >= kFewestOthers && score->share >= kMajority &&
         unconfirmedFault().empty() && !score->isWide();
}

bool Comparison::isScaleUsual() const {
  return !runs.empty() && allOf(runs, &ComparedRun::isScaleEstimated);
}

bool Comparison::areCopies() const {
  const auto alike = copies();
  return !alike.empty() && alike.front().size() == runs.size();
}

bool Comparison::hasBoth(const ComparedPair& pair) const {
  return findRun(runs, pair.a) && findRun(runs, pair.b);
}

std::size_t Comparison::countBreaks(const std::string& run) const {
  return countIf(breaks, [&](const MapBreak& found) {
    return found.run == run && found.kind() != BreakClass::slight;
  });
}

std::string Comparison::faultOfReference(const ComparedRun& run) const {
  for (const MapBreak& found : breaks) {
    if (found.run != reference || found.kind() == BreakClass::slight) continue;
    const std::string at =
        found.keyFrame ? formatted("at key frame %zu, ", *found.keyFrame) : std::string();
    return "the reference itself breaks " + at +
           formatted("by %.1f degrees and %.2f m", std::abs(found.rotation) * 180 / M_PI,
                     found.shift);
  }
  if (referenceDoubled > 0)
    return formatted("the reference itself has drawn a place twice, %.2f m apart",
                     referenceDoubled);
  if (!run.score || run.score->fitsReference()) return "";
  return formatted(
      "%.0f %% of what it and the reference found of each other contradicts the rest: the "
      "reference may be broken itself",
      100 * run.score->givenUp);
}

std::string Comparison::faultOf(const ComparedRun& run) const {
  const std::string fault = faultOfReference(run), own = run.score ? run.unconfirmedFault() : "";
  return fault.empty() && !own.empty() ? "it " + own : fault;
}

bool Comparison::isPlaceDoubtful(const std::string& run) const {
  if (const ComparedRun* found = findRun(runs, run); found && found->isPlaceBorneOut())
    return false;
  const auto isOfRun = [&](const ComparedPair& pair) {
    return pair.isSameSite && (pair.a == run || pair.b == run);
  };
  if (!anyOf(pairs, isOfRun)) return false;
  std::size_t own = 0, largest = 0;
  for (const Names& names : setsOf(pairs, [](const ComparedPair& pair) {
         return pair.isSameSite && pair.confidence >= kSureConfidence;
       })) {
    largest = std::max(largest, names.size());
    if (std::binary_search(names.begin(), names.end(), run)) own = names.size();
  }
  return own == 0 || own < largest;
}

std::vector<std::vector<std::string>> Comparison::copies() const {
  return setsOf(pairs, [](const ComparedPair& pair) { return pair.areCopies; });
}

std::vector<std::vector<std::string>> Comparison::edits() const {
  return setsOf(pairs, [](const ComparedPair& pair) { return pair.areCopies || pair.areEdits; });
}

Certainty Comparison::certaintyOf(const ComparedRun& run) const {
  if (!run.score || !run.score->isMeaningful) return Certainty::cannotTell;
  const RunScore& score = *run.score;
  // Walls that lie so far off stand where others have seen free space.
  const bool areExplained = run.isPlaceBorneOut() && score.mapError >= kSameWhereBent;
  if (isPlaceDoubtful(run.name) || (run.addedWalls() && !areExplained)) return Certainty::doubtful;
  const bool isOdd =
      score.jitter >= kSmeared || score.isScaleDisputed || !run.isBorneOut() || isOneDrive;
  return run.partialCoverage() || score.isWide() || isOdd || score.share < kNearlyAll
             ? Certainty::likely
             : Certainty::sure;
}

}  // namespace roomgraph
