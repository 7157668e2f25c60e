#include "summarize.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "explain_comparison.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/place_runs.h"
#include "roomgraph/relate/shared_drives.h"

namespace roomgraph {
namespace {

std::vector<ComparedRun> runsOf(const Findings& found) {
  std::vector<ComparedRun> runs;
  for (std::size_t i = 0; i < found.site.runs.size(); ++i) {
    const Run& run = *found.site.runs[i];
    ComparedRun compared;
    compared.name = run.name, compared.file = run.file, compared.sha256 = run.sha256;
    compared.pose = found.site.poses[i];
    compared.score = found.scores[i], compared.welded = found.welded[i];
    compared.measures = found.measures.runs[i];
    compared.resolution = run.resolution, compared.isScaleEstimated = run.isScaleEstimated;
    const MapError error = found.welded[i] ? MapError() : found.consensus.errorOf(i);
    compared.path = runPath(run, found.site.poses[i], error);
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
  sortBy(runs, key);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].score) continue;
    // Errors that are equal but for rounding share a rank.
    const bool isSame = i > 0 && runs[i].score->isMeaningful == runs[i - 1].score->isMeaningful &&
                        runs[i].score->mapError - runs[i - 1].score->mapError < 1e-6;
    runs[i].rank = isSame ? runs[i - 1].rank : i + 1;
  }
}

/** The figures as files hold them: so all that is printed and judged of a comparison, or of its
 *  file, has the same digits. */
void roundScores(std::vector<ComparedRun>& runs) {
  for (ComparedRun& run : runs) {
    if (!run.score) continue;
    RunScore& score = *run.score;
    for (double* figure : {&score.score, &score.low, &score.high, &score.mapError, &score.errorLow,
                           &score.errorHigh})
      *figure = rounded(*figure);
  }
}

ComparedPair pairOf(const Run& a, const Run& b, const MapPair& related) {
  const Alignment& alignment = related.alignment;
  ComparedPair pair;
  pair.a = a.name, pair.b = b.name;
  pair.areCopies = related.areIdentical;
  pair.isSameSite = alignment.isSameSite;
  if (alignment.best) pair.transform = alignment.pose;
  pair.confidence = alignment.confidence;
  pair.overlap = alignment.overlap;
  if (alignment.runnerUp) pair.runnerUp = alignment.runnerUp->pose;
  pair.runnerUpConfidence = alignment.runnerUpConfidence;
  return pair;
}

/** All pairs that were related; those of the site have measures. */
std::vector<ComparedPair> pairsOf(const std::vector<Run>& runs, const MapPairs& related,
                                  const Findings& found) {
  PairTable<ComparedPair> pairs(runs.size(), related.pairs());
  for (const auto& [a, b] : pairs.pairs()) pairs(a, b) = pairOf(runs[a], runs[b], related(a, b));
  const std::vector<std::size_t>& members = found.site.members;
  for (const auto& [i, j] : found.measures.pairs.pairs()) {
    ComparedPair& pair = pairs(members[i], members[j]);
    pair.measures = found.measures.pairs(i, j);
    pair.areEdits = found.pairs(i, j).areEdits && !pair.areCopies;
  }
  return pairs.values();
}

/** What each run says of a room, in the order of the compared runs. */
std::vector<SiteRoom> roomsOf(const Findings& found, const std::vector<ComparedRun>& runs) {
  std::map<std::string, std::size_t> placeOf;
  for (std::size_t i = 0; i < runs.size(); ++i) placeOf[runs[i].name] = i;
  std::vector<SiteRoom> rooms = found.rooms;
  for (SiteRoom& room : rooms)
    sortBy(room.runs, [&](const RoomInRun& in) { return placeOf[in.run]; });
  return rooms;
}

std::vector<std::string> namesOf(const std::vector<Run>& runs,
                                 const std::vector<std::size_t>& some) {
  auto names = mapped(some, [&](std::size_t run) { return runs[run].name; });
  std::sort(names.begin(), names.end());
  return names;
}

/** Whether this is so of most pairs of a run that is not of the site with those that are. */
template <class IsSo>
bool isSoInMost(const MapPairs& related, std::size_t run, const Site& site, const IsSo& isSo) {
  std::size_t looked = 0, so = 0;
  for (const std::size_t other : related.othersOf(run)) {
    if (!site.has(other)) continue;
    ++looked, so += isSo(related(run, other)) ? 1 : 0;
  }
  return 2 * so > looked;
}

std::vector<LeftOutRun> leftOutOf(const std::vector<Run>& runs, const MapPairs& related,
                                  const Site& site) {
  std::vector<LeftOutRun> leftOut;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (site.has(i)) continue;
    const bool isMirrored =
        isSoInMost(related, i, site, [](const MapPair& pair) { return pair.alignment.isMirrored; });
    const bool isStorey =
        isSoInMost(related, i, site, [](const MapPair& pair) { return pair.areStoreys; });
    std::string reason = runs.size() == 2 ? "does not lie in the same site as the other"
                                          : "does not lie in the same site as the others";
    bool hasMates = false;
    for (const std::vector<std::size_t>& other : site.others)
      if (std::binary_search(other.begin(), other.end(), i))
        reason = "lies in another site: " + listed(namesOf(runs, other)), hasMates = true;
    if (isMirrored) reason = "is mirrored: is the lidar mounted upside down?";
    if (isStorey) reason += "; its outer walls agree, its inner ones do not: another storey?";
    leftOut.push_back({runs[i].name, runs[i].file, reason, true, hasMates});
  }
  return leftOut;
}

/** The sentence on runs of other scales; empty where all agree. */
std::string scalesOf(const Findings& found) {
  std::vector<std::string> larger, smaller;
  double large = 0, small = 0;
  for (std::size_t i = 0; i < found.site.runs.size(); ++i) {
    const MapError error = found.consensus.errorOf(i);
    if (!found.scores[i] || error.scaleSet == ScaleSet::one) continue;
    const bool isLarger = error.scaleSet == ScaleSet::larger;
    (isLarger ? larger : smaller).push_back(found.site.runs[i]->name);
    (isLarger ? large : small) += error.scale;
  }
  if (larger.empty() || smaller.empty()) return "";
  std::sort(larger.begin(), larger.end());
  std::sort(smaller.begin(), smaller.end());
  return scalesNote(larger, smaller,
                    large / double(larger.size()) / (small / double(smaller.size())));
}

/** Whether maps without scans may be of one drive unnoticed: edits of one picture are known. */
bool areDrivesUnknown(const Findings& found) {
  const DistinctMaps maps(bendsOf(found.pairs));
  std::set<std::size_t> bare;
  for (std::size_t i = 0; i < found.site.runs.size(); ++i)
    if (found.site.runs[i]->scans.empty()) bare.insert(maps.voiceOf(i));
  return bare.size() > 1;
}

/** What the verdict cannot know of: other sites among the runs, and drives that runs share. */
std::string caveatsOf(const std::vector<Run>& runs, const Findings& found,
                      const std::vector<std::vector<std::size_t>>& drives) {
  const Site& site = found.site;
  std::string text = scalesOf(found);
  if (!site.others.empty()) {
    std::vector<std::vector<std::string>> sites{namesOf(runs, site.members)};
    for (const auto& other : site.others) sites.push_back(namesOf(runs, other));
    text += otherSitesNote(sites);
  }
  for (const std::vector<std::size_t>& drive : drives) {
    const auto members = mapped(drive, [&](std::size_t run) { return site.members[run]; });
    text += sharedDriveNote(namesOf(runs, members), site.runs.size());
  }
  const auto bare = countIf(site.runs, [](const Run* r) { return r->scans.empty(); });
  const bool isCompared = anyOf(found.scores, [](const auto& score) { return score.has_value(); });
  if (areDrivesUnknown(found) && isCompared) text += unknownDrivesNote(bare, site.runs.size());
  return text;
}

}  // namespace

Comparison summarize(const std::vector<Run>& runs, const MapPairs& related, const Findings& found) {
  Comparison result;
  if (found.site.reference) result.reference = found.site.runs[*found.site.reference]->name;
  for (const std::vector<MapBreak>& ofRun : found.breaks)
    result.breaks.insert(result.breaks.end(), ofRun.begin(), ofRun.end());
  sortDownBy(result.breaks, &MapBreak::size);
  for (const std::size_t run : found.pairs.core) result.core.push_back(found.site.runs[run]->name);
  std::sort(result.core.begin(), result.core.end());
  auto drives = sharedDrives(found.site.runs);
  result.referenceDoubled = found.referenceDoubled;
  result.isOneDrive = drives.size() == 1 && drives[0].size() == found.site.runs.size();
  result.runs = runsOf(found);
  rank(result.runs);
  roundScores(result.runs);
  result.pairs = pairsOf(runs, related, found);
  for (ComparedRun& run : result.runs) run.reason = reasonOf(run, result);
  result.rooms = roomsOf(found, result.runs);
  result.leftOut = leftOutOf(runs, related, found.site);
  if (result.areCopies()) drives.clear();  // the verdict says more
  result.verdict = verdictOf(result) + usualScaleNote(result) + copiesNote(result) +
                   caveatsOf(runs, found, drives);
  return result;
}

std::vector<PathPose> runPath(const Run& run, const Transform2D& pose, const MapError& error) {
  const bool hasErrors = error.errors.size() == run.scans.size();
  const auto isConfirmed = [&](std::size_t k) {
    return error.isConfirmed.empty() || error.isConfirmed[k];
  };
  std::vector<PathPose> path;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    const ScanWalls& scan = run.scans[k];
    path.push_back({scan.keyFrame, scan.time, pose * scan.pose,
                    hasErrors && isConfirmed(k) ? std::optional(error.errors[k]) : std::nullopt});
  }
  return path;
}

}  // namespace roomgraph
