#pragma once
#include <string>
#include <vector>

namespace roomgraph {

/** A measure, and all that is said about it: tables, labels and tests are made from this. What it
 *  is stands in docs/scoring.md. */
struct MeasureKind {
  const char* name;     ///< as in the files
  const char* label;    ///< for people
  const char* unit;     ///< "m", "deg", "pieces", or "1" for a share of 1
  double leastSupport;  ///< below it the measure is not meaningful [wall points, rooms,
                        ///< m2 of the site, vertices, m of path, or scans]
};

/** Those of a run, in the order of all tables. */
const std::vector<MeasureKind>& runMeasureKinds();

/** Of a run or a pair; null for none of this name. */
const MeasureKind* findMeasureKind(const std::string& name);

}  // namespace roomgraph
