#pragma once
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/compare/compare_runs.h"

namespace roomgraph::test {

/** A name as nobody should give: it would end a script, open another, and call the network. */
extern const char* const kHostileName;

/** What a report is made of. */
struct SampleComparison {
  Comparison comparison;
  std::vector<Run> runs;
};

/** Four runs of a building with four rooms and a corridor, each in its own frame: the third has a
 *  hostile name, lacks a room and bends in two places, the fourth has not looked into the east. One
 *  file is left out. */
SampleComparison sampleComparison();
/** The same, made once. */
const SampleComparison& sample();

}  // namespace roomgraph::test
