#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** One figure, and how far it can be trusted. */
struct Measure {
  std::string name;             ///< as in the file
  std::optional<double> value;  ///< none where nothing supports it
  const char* unit = "1";       ///< "m", "deg" or "1", a share of 1
  double support = 0;           ///< how many things were counted: wall points, cells or rooms
  /** The range of the value when any one of the other runs is left out; none without a value, or
   *  with a single other run. */
  std::optional<double> low, high;
  bool isMeaningful = false;  ///< enough other runs, and enough support
};

/** What the walls of one run say against those of the others. */
struct RunScore {
  double bend = 0;   ///< against the others, each weighted by its trust [m]
  double share = 0;  ///< of the walls that the others have, too; weighted alike
  double mapError = 0, errorLow = 0, errorHigh = 0;  ///< estimate of the true map error [m]
  double score = 100, low = 100, high = 100;         ///< 0 to 100, falls with the map error
  double trust = 0;           ///< weight of this run in the consensus, the largest of all runs is 1
  double support = 0;         ///< wall points that were compared
  std::size_t others = 0;     ///< runs it was compared with
  bool isMeaningful = false;  ///< see scoreRuns
};

/** A run that could be placed. */
struct ComparedRun {
  std::string name, file;
  Transform2D pose;               ///< site <- run
  std::optional<RunScore> score;  ///< none for the reference, and where no wall could be compared
  std::size_t rank = 0;           ///< 1 is best, equal errors share a rank; 0 without a score
  std::vector<Measure> measures;
  std::string reason;             ///< of the score, one line
  double resolution = 0;          ///< side of a cell of its map [m]
  bool isScaleEstimated = false;  ///< `resolution` was estimated from the other runs
};

/** Two runs, placed or not. */
struct ComparedPair {
  std::string a, b;  ///< names
  bool isSameSite = false;
  std::optional<Transform2D> transform;  ///< a <- b; none where a run has no walls
  double confidence = 0;                 ///< probability that it is right
  double overlap = 0;                    ///< share of the smaller free space that is free in both
  std::optional<Transform2D> runnerUp;   ///< the next best pose
  double runnerUpConfidence = 0;
  std::vector<Measure> measures;
};

/** A run that is not compared, and why. */
struct LeftOutRun {
  std::string name, file, reason;
  bool isOtherSite = false;  ///< it could be read, but does not lie in the site of the others
};

/** A place where a map bends: what lies on one side of it is turned and shifted as a whole. */
struct MapBreak {
  std::string run;      ///< name
  Point place;          ///< [m, site frame]
  double rotation = 0;  ///< of the far side against the near one [rad]
  double shift = 0;     ///< of the far side at `place` [m]
};

/** Whether a run knows a room of the site. */
enum class RoomSighting {
  seen,       ///< one of its areas is this room, or (without pieces) its space is there, but in no
              ///< area, as nothing leads to it
  gone,       ///< it has looked there, and no area of it is this room
  unvisited,  ///< it has not looked there
};

/** What one run says of a room of the site. All figures are against the consensus of the runs that
 *  have seen it. */
struct RoomInRun {
  std::string run;  ///< name
  RoomSighting sighting = RoomSighting::unvisited;
  int pieces = 0;                           ///< areas of the run that make it up; 2 or more: split
  bool isMerged = false;                    ///< its area holds another room of the site, too
  std::optional<double> shift;              ///< of its middle [m]
  std::optional<double> areaChange;         ///< share, 0.1 for 10 % larger
  std::optional<double> boundaryAgreement;  ///< share of its outline that others draw, too
  std::optional<double> lengthError;        ///< of a corridor, end to end; longer: positive [m]
  int doorsGained = 0, doorsLost = 0;
};

/** An opening of a room that most runs have. */
struct SiteDoor {
  Point place;       ///< [m, site frame]
  double width = 0;  ///< [m]
  std::string to;    ///< id of the room behind it; empty for none
};

/** A room or corridor of the site, over all runs. */
struct SiteRoom {
  std::string id;    ///< stays the same from call to call where names are kept
  std::string name;  ///< given by the user; else the id
  bool isCorridor = false;
  Point center;     ///< [m, site frame]
  Polygon polygon;  ///< as that run draws it that the others agree with most [m, site frame]
  double area = 0;  ///< median over the runs that have seen it all [m2]
  std::vector<SiteDoor> doors;
  std::vector<RoomInRun> runs;  ///< in the order of Comparison::runs
};

/** What is known of several runs of one site. */
struct Comparison {
  std::vector<ComparedRun> runs;         ///< best first, then by name; those without a rank last
  std::vector<ComparedPair> pairs;       ///< of all runs that have walls, by name
  std::vector<LeftOutRun> leftOut;       ///< by name
  std::vector<SiteRoom> rooms;           ///< by id
  std::vector<MapBreak> breaks;          ///< by run, then along it
  std::optional<std::string> reference;  ///< name of the run that the others are measured against
  std::string verdict;                   ///< one line
};

}  // namespace roomgraph
