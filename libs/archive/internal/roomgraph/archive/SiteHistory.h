#pragma once
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/ledger/SiteFile.h"
#include "roomgraph/ledger/SiteRoom.h"
#include "roomgraph/measures/Measure.h"

namespace roomgraph {

/** Names of figures that every scored run has, besides those of runMeasureKinds(). */
constexpr const char* kMapError = "map_error_m";
constexpr const char* kScore = "score";
constexpr const char* kBreaks = "breaks";         ///< those that are not slight
constexpr const char* kSelfError = "self_error";  ///< of a run that others do not judge [m]
constexpr const char* kSelfBreaks = "self_breaks";

/** What a run has of a room of the site. */
struct RoomSeen {
  std::string room;  ///< id
  RoomSighting sighting = RoomSighting::unvisited;
  int pieces = 0;
  bool isMerged = false;
  int doors = 0;                                   ///< of the room that the run has
  std::optional<double> area;                      ///< of the room in this run [m2]
  std::optional<double> shift, boundaryAgreement;  ///< as in RoomInRun
};

/** A run of an archive. Of one that is to be added, no more is known than where it comes from. */
struct HistoryRun {
  std::string sha256, robot, file;
  double time = 0;        ///< [s since 1970]
  bool isPlaced = true;   ///< false where it is of another site
  std::string reason{};   ///< of its score, or why it has none
  std::string version{};  ///< of the program that the figures are from
  /** Of the first comparison that could tell them; see figuresOf(). */
  std::vector<Measure> figures{};
  std::vector<RoomSeen> rooms{};  ///< by id
};

/** All that an archive knows of a site. */
struct SiteHistory {
  std::string site;
  std::vector<HistoryRun> runs;  ///< by time, then by content
  SiteFile ledger;
};

/** All figures of a compared run, with those of its score, as an archive keeps them. */
std::vector<Measure> figuresOf(const ComparedRun& run, const Comparison& comparison);

/** What a compared run has of each room of the comparison. */
std::vector<RoomSeen> roomsOf(const ComparedRun& run, const Comparison& comparison);

/** The run whose file as listed, the name of that file, or at least eight digits of its SHA-256 is
 *  `name`. `archive` is named in errors.
 *  @throws DataError where there is no such run, or where several could be meant. */
const HistoryRun& namedRun(const std::vector<HistoryRun>& runs, const std::string& name,
                           const std::string& archive);

}  // namespace roomgraph
