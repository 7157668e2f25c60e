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

}  // namespace roomgraph::test
