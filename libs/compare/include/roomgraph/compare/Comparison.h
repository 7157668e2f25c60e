#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** One figure, and how far it can be trusted. */
struct Measure {
  std::string name;             ///< as in the file
  std::optional<double> value;  ///< none where nothing supports it
  const char* unit = "1";       ///< "m" or "1", a share of 1
  double support = 0;           ///< how many things were counted: wall points, cells or rooms
  /** The range of the value when any one of the other runs is left out; none without a value, or
   *  with a single other run. */
  std::optional<double> low, high;
  bool isMeaningful = false;  ///< enough other runs, and enough support
};

/** What the walls of one run say against those of the others. */
struct RunScore {
  double distance = 0;                               ///< consensus distance of the walls [m]
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
  std::string reason;  ///< of the score, one line
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

/** What is known of several runs of one site. */
struct Comparison {
  std::vector<ComparedRun> runs;         ///< best first, then by name; those without a rank last
  std::vector<ComparedPair> pairs;       ///< of all runs that have walls, by name
  std::vector<LeftOutRun> leftOut;       ///< by name
  std::optional<std::string> reference;  ///< name of the run that the others are measured against
  std::string verdict;                   ///< one line
};

}  // namespace roomgraph
