#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** A measure, and all that is said about it: tables, labels and tests are made from this. What it
 *  is computed from stands in docs/scoring.md. */
struct MeasureKind {
  const char* name;      ///< as in the files
  const char* label;     ///< for people
  const char* unit;      ///< "m", "deg", "pieces", or "1" for a share of 1
  double leastSupport;   ///< below it the measure is not meaningful [what was counted]
  const char* sentence;  ///< what it is
};

/** Those of a run, in the order of all tables. */
const std::vector<MeasureKind>& runMeasureKinds();

/** The further ones, which only a pair of runs has. */
const std::vector<MeasureKind>& pairMeasureKinds();

/** Of a run or a pair; null for none of this name. */
const MeasureKind* findMeasureKind(const std::string& name);

}  // namespace roomgraph
