#include "summarize.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "explain_comparison.h"
#include "run_path.h"

namespace roomgraph {
namespace {

constexpr double kSameError = 1e-6;  // runs whose errors differ by less share a rank [m]

std::vector<ComparedRun> runsOf(const Findings& found) {
  std::vector<ComparedRun> runs;
  for (std::size_t i = 0; i < found.site.runs.size(); ++i) {
    const Run& run = *found.site.runs[i];
    ComparedRun compared;
    compared.name = run.name, compared.file = run.file, compared.sha256 = run.sha256;
    compared.pose = found.site.poses[i];
    compared.score = found.scores[i];
    compared.measures = found.measures.runs[i];
    compared.resolution = run.resolution, compared.isScaleEstimated = run.isScaleEstimated;
    compared.path = runPath(run, found.site.poses[i], found.consensus.errors[i]);
    runs.push_back(std::move(compared));
  }
  return runs;
}

void rank(std::vector<ComparedRun>& runs) {
  const auto key = [](const ComparedRun& run) {
    const bool isMeaningful = run.score && run.score->isMeaningful;
    return std::make_tuple(!run.score, !isMeaningful, run.score ? run.score->mapError : 0,
                           run.name);
  };
  std::sort(runs.begin(), runs.end(),
            [&](const ComparedRun& l, const ComparedRun& r) { return key(l) < key(r); });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].score) continue;
    const bool isSame = i > 0 && runs[i].score->isMeaningful == runs[i - 1].score->isMeaningful &&
                        runs[i].score->mapError - runs[i - 1].score->mapError < kSameError;
    runs[i].rank = isSame ? runs[i - 1].rank : i + 1;
  }
}

ComparedPair pairOf(const Run& a, const Run& b, const Alignment& alignment) {
  ComparedPair pair;
  pair.a = a.name, pair.b = b.name;
  pair.isSameSite = alignment.isSameSite;
  if (alignment.best) pair.transform = alignment.pose;
  pair.confidence = alignment.confidence;
  pair.overlap = alignment.overlap;
  if (alignment.runnerUp) pair.runnerUp = alignment.runnerUp->pose;
  pair.runnerUpConfidence = alignment.runnerUpConfidence;
  return pair;
}

/** All pairs; those of the site have measures. */
std::vector<ComparedPair> pairsOf(const std::vector<Run>& runs, const MapPairs& related,
                                  const Findings& found) {
  PairTable<ComparedPair> pairs(runs.size());
  for (const auto& [a, b] : pairs.pairs())
    pairs(a, b) = pairOf(runs[a], runs[b], related(a, b).alignment);
  const std::vector<std::size_t>& members = found.site.members;
  for (const auto& [i, j] : found.measures.pairs.pairs())
    pairs(members[i], members[j]).measures = found.measures.pairs(i, j);
  return pairs.values();
}

/** What each run says of a room, in the order of the compared runs. */
std::vector<SiteRoom> roomsOf(const Findings& found, const std::vector<ComparedRun>& runs) {
  std::map<std::string, std::size_t> placeOf;
  for (std::size_t i = 0; i < runs.size(); ++i) placeOf[runs[i].name] = i;
  std::vector<SiteRoom> rooms = found.rooms;
  for (SiteRoom& room : rooms)
    std::sort(room.runs.begin(), room.runs.end(), [&](const RoomInRun& l, const RoomInRun& r) {
      return placeOf[l.run] < placeOf[r.run];
    });
  return rooms;
}

std::vector<LeftOutRun> leftOutOf(const std::vector<Run>& runs, const Site& site) {
  std::vector<LeftOutRun> leftOut;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!std::binary_search(site.members.begin(), site.members.end(), i))
      leftOut.push_back(
          {runs[i].name, runs[i].file, "does not lie in the same site as the others", true});
  return leftOut;
}

}  // namespace

Comparison summarize(const std::vector<Run>& runs, const MapPairs& related, const Findings& found) {
  Comparison result;
  if (found.site.reference) result.reference = found.site.runs[*found.site.reference]->name;
  for (const std::vector<MapBreak>& ofRun : found.breaks)
    result.breaks.insert(result.breaks.end(), ofRun.begin(), ofRun.end());
  result.runs = runsOf(found);
  rank(result.runs);
  for (ComparedRun& run : result.runs) run.reason = reasonOf(run, result);
  result.pairs = pairsOf(runs, related, found);
  result.rooms = roomsOf(found, result.runs);
  result.leftOut = leftOutOf(runs, found.site);
  result.verdict = verdictOf(result);
  return result;
}

}  // namespace roomgraph
