#include "roomgraph/measures/Measure.h"

#include <algorithm>

namespace roomgraph {

const Measure* find(const std::vector<Measure>& measures, const std::string& name) {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == measures.end() ? nullptr : &*found;
}

}  // namespace roomgraph
