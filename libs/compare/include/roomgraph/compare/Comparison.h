#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/compare/RunScore.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/ledger/SiteRoom.h"
#include "roomgraph/measures/Measure.h"

namespace roomgraph {

/** Of the walls in one place, the share that a run may have and no other: moved furniture adds
 *  less, and hardly any straight ones, see `straight_walls_added`. */
constexpr double kMostAdded = 0.5, kMostStraightAdded = 0.03;

/** How sure what is told of a run is; see Comparison::certaintyOf. */
enum class Certainty { sure, likely, doubtful, cannotTell };

[[nodiscard]] constexpr std::array<const char*, 4> enumNames(Certainty) {
  return {"sure", "likely", "doubtful", "cannot tell"};
}

/** Where the robot was at a key frame, as the run's map has it. */
struct PathPose {
  std::size_t keyFrame = 0;    ///< its number in the file of the run, from 0
  std::optional<double> time;  ///< of its scan [s since 1970]
  Transform2D pose;            ///< site <- robot
  /** How far what it has drawn lies from the consensus, RMS [m]; none where no other run bears
   *  out where it lies. */
  std::optional<double> error;
};

/** A run that could be placed. */
struct ComparedRun {
  std::string name, file, sha256;  ///< of its map; `name` is unique
  /** Where its map lay, from the folder of a saved comparison; empty where that is not told. */
  std::string relativePath{};
  Transform2D pose;               ///< site <- run
  std::optional<RunScore> score;  ///< none for the reference, and where no wall could be compared
  std::size_t rank = 0;           ///< 1 is best, equal errors share a rank; 0 without a score
  std::vector<Measure> measures;
  std::string reason;             ///< of the score, one line
  double resolution = 0;          ///< side of a cell of its map [m]
  bool isScaleEstimated = false;  ///< `resolution` was estimated from the other runs
  std::vector<PathPose> path;     ///< by key frame; empty for a run without scans
  /** Key frames that it has drawn at one place, and that refute that: then it has no score. */
  std::optional<std::pair<std::size_t, std::size_t>> welded;

  /** The measure `coverage`, where it is meaningful, and is less than kNearlyAll. */
  [[nodiscard]] std::optional<double> partialCoverage() const;
  /** That of the measures `straight_walls_added` and `walls_added` which is meaningful and above
   *  its limit; null where neither is. */
  [[nodiscard]] const Measure* addedWalls() const;
  /** That it has welded two places, or see unconfirmedFault; empty without either. */
  [[nodiscard]] std::string unconfirmedFault() const;
  /** Whether two others or more bear out where its scans lie: half of its walls were found there,
   *  nothing is contradicted, and its interval is not wide. False for a run without scans. */
  [[nodiscard]] bool isPlaceBorneOut() const;
  /** Whether its score is borne out, and no place of its map is other than the others show it. */
  [[nodiscard]] bool isBorneOut() const {
    return score && unconfirmedFault().empty() && !addedWalls();
  }
};

/** Two runs, placed or not. */
struct ComparedPair {
  std::string a, b;         ///< names
  bool isSameSite = false;  ///< the two maps show one building
  bool areCopies = false;   ///< they are the same, cell by cell
  bool areEdits = false;    ///< or no copies, but edits of one picture, one without scans
  std::optional<Transform2D> transform;  ///< a <- b; none where a run has no walls
  double confidence = 0;                 ///< probability that it is right
  double overlap = 0;                    ///< share of the smaller free space that is free in both
  std::optional<Transform2D> runnerUp;   ///< the next best pose
  double runnerUpConfidence = 0;         ///< probability that it is right
  std::vector<Measure> measures;
};

/** A run that is not compared, and why. */
struct LeftOutRun {
  std::string name, file, reason;              ///< one line on why
  bool isOtherSite = false, hasMates = false;  ///< read, but of another site; which others share
};

/** An option and its value, as text for people. */
struct UsedOption {
  std::string section, name, value, unit, sentence;  ///< as in `roomgraph config`
};

/** What a gate says of a comparison. */
struct GateVerdict {
  std::vector<std::string> complaints;  ///< "run: what is wrong" for each thing that must not be
  std::vector<std::string> candidates;  ///< names of the runs that were judged; empty for all
  std::vector<std::string> asked;       ///< what was asked, a line each
  /** Where it passes: "run: by how much", of each figure asked for that of the run closest to its
   *  limit. */
  std::vector<std::string> margins{};

  [[nodiscard]] bool isPassed() const { return complaints.empty(); }  ///< nothing is wrong
};

/** What is known of several runs of one site. A saved thing: comparisonJson writes all of it, and
 *  parseComparisonJson reads it back. */
struct Comparison {
  std::vector<ComparedRun> runs;    ///< best first, then by name; those without a rank last
  std::vector<ComparedPair> pairs;  ///< that were related: all of few runs, by name
  std::vector<LeftOutRun> leftOut;  ///< by name
  std::vector<SiteRoom> rooms;      ///< by id
  std::vector<MapBreak> breaks;     ///< the largest first; of equal ones by run, then along it
  /** Names of the runs among which the consensus was worked out, where these are not all. */
  std::vector<std::string> core;
  std::optional<std::string> reference;  ///< name of the run that the others are measured against
  double referenceDoubled = 0;      ///< how far apart the reference has drawn one place twice [m]
  bool isOneDrive = false;          ///< all runs share its scans, and perhaps its errors
  std::string verdict;              ///< one line
  std::vector<UsedOption> options;  ///< all that were used, in the order of the work
  std::optional<GateVerdict> gate;  ///< none where nothing was asked
  std::vector<std::string> files;   ///< all that was written of it, without their folder

  /** Whether a run may lie in the wrong place, so that its breaks and its error may be those of
   *  that place: no chain of pairs of kSureConfidence joins it to most of the others, and they do
   *  not bear its place out either. False for a run without pairs. O(pairs). */
  [[nodiscard]] bool isPlaceDoubtful(const std::string& run) const;
  /** Whether no map told a scale: metres are those of a usual one, and only cells are right. */
  [[nodiscard]] bool isScaleUsual() const;
  [[nodiscard]] std::size_t countBreaks(const std::string& run) const;  ///< that are not slight
  /** Why nobody can be measured by the reference: it breaks itself, or fits the run only in part;
   *  empty where it is sound, and without one. O(breaks). */
  [[nodiscard]] std::string faultOfReference(const ComparedRun& run) const;
  /** Why the error of a run cannot be told: that, or "it has drawn ..."; or empty. O(breaks). */
  [[nodiscard]] std::string faultOf(const ComparedRun& run) const;
  /** The one word on a run that verdict, tables, pages and other programs agree on, in O(pairs):
   *  *cannot tell* without a meaningful score, *doubtful* where its place is or it has walls that
   *  no other has (addedWalls) and that no map error of kSameWhereBent explains, *likely* where it
   *  shows less than kNearlyAll of the site or the others of its walls or do not bear it out, it is
   *  smeared, its scale disputed, all runs of one drive or its interval wide; else *sure*. */
  [[nodiscard]] Certainty certaintyOf(const ComparedRun& run) const;
  [[nodiscard]] bool areCopies() const;                        ///< all runs are of one map
  [[nodiscard]] bool hasBoth(const ComparedPair& pair) const;  ///< neither run of it is left out
  /** The names of the runs of each map that is there more than once, ascending. O(pairs). */
  [[nodiscard]] std::vector<std::vector<std::string>> copies() const;
  /** The same of each picture of which there are several edits, copies among them. */
  [[nodiscard]] std::vector<std::vector<std::string>> edits() const;
};

}  // namespace roomgraph
