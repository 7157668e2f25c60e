#pragma once
#include "MapText.h"
#include "roomgraph/evaluation/stability.h"

namespace roomgraph::test {

/** The office of the drawings with few, but different, noisy maps. */
struct SmallExperiment {
  GreyMap map;
  ExtractOptions extract;
  StabilityOptions options;
};

inline SmallExperiment smallExperiment() {
  const MapText text = readMapText("office");
  SmallExperiment experiment{greyMap(text), optionsOf(text), {}};
  experiment.options.distances = {1, 3};
  experiment.options.percents = {2, 8};
  experiment.options.repeats = 2;
  return experiment;
}

/** All of an experiment, one noisy map after the other. */
inline Stability stability(const SmallExperiment& of) {
  const StabilityBase base = stabilityBase(of.map, of.extract, of.options);
  std::vector<RunMeasures> measures;
  for (const StabilityRun& run : stabilityRuns(of.options))
    measures.push_back(measureRun(base, run));
  return summarizeStability(of.map, base, of.options, measures);
}

}  // namespace roomgraph::test
