#include "roomgraph/archive/SiteHistory.h"

#include <filesystem>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

bool isMeant(const std::string& name, const HistoryRun& run) {
  if (name.empty()) return false;
  return name == run.file || name == fileName(run.file) ||
         fs::absolute(name).lexically_normal() == run.file ||
         (name.size() >= 8 && run.sha256.compare(0, name.size(), name) == 0);
}

Measure figure(const char* name, double value, const char* unit, const RunScore& score) {
  return {name, value, unit, score.support, std::nullopt, std::nullopt, score.isMeaningful};
}

void addScore(std::vector<Measure>& figures, const RunScore& score) {
  Measure error = figure(kMapError, score.mapError, "m", score);
  error.low = score.errorLow, error.high = score.errorHigh;
  Measure points = figure(kScore, score.score, "1", score);
  points.low = score.low, points.high = score.high;
  figures.insert(figures.end(), {error, points, figure("confirmed", score.confirmed, "1", score),
                                 figure("contradicted", score.contradicted, "1", score),
                                 figure("shared_walls", score.share, "1", score),
                                 figure("trust", score.trust, "1", score)});
}

/** Doors of the site that a run has: not those that it may have, as then a door beside furniture
 *  that most runs come to see would change all later runs at once. */
int doorsSeen(const SiteRoom& room, const std::string& run) {
  return int(countIf(room.doors, [&](const SiteDoor& door) { return contains(door.seenIn, run); }));
}

}  // namespace

const HistoryRun& namedRun(const std::vector<HistoryRun>& runs, const std::string& name,
                           const std::string& archive) {
  const HistoryRun* meant = nullptr;
  for (const HistoryRun& run : runs) {
    if (!isMeant(name, run)) continue;
    if (meant)
      throw DataError(archive + ": has several runs named " + name +
                      ": name one by its whole file or its SHA-256, which 'export' tells");
    meant = &run;
  }
  if (!meant)
    throw DataError(archive + ": has no run " + name + ": 'list' names those that it has");
  return *meant;
}

std::vector<Measure> figuresOf(const ComparedRun& run, const Comparison& comparison) {
  std::vector<Measure> figures;
  if (run.score) {
    addScore(figures, *run.score);
    figures.push_back(figure(kBreaks, double(comparison.countBreaks(run.name)), "1", *run.score));
  }
  figures.insert(figures.end(), run.measures.begin(), run.measures.end());
  return figures;
}

std::vector<RoomSeen> roomsOf(const ComparedRun& run, const Comparison& comparison) {
  std::vector<RoomSeen> rooms;
  for (const SiteRoom& room : comparison.rooms)
    for (const RoomInRun& in : room.runs) {
      if (in.run != run.name) continue;
      RoomSeen seen;
      seen.room = room.id, seen.sighting = in.sighting;
      seen.pieces = in.pieces, seen.isMerged = in.isMerged;
      seen.doors = in.doorsGained + doorsSeen(room, run.name);
      if (in.areaChange) seen.area = room.area * (1 + *in.areaChange);
      seen.shift = in.shift, seen.boundaryAgreement = in.boundaryAgreement;
      rooms.push_back(seen);
    }
  return rooms;
}

}  // namespace roomgraph
