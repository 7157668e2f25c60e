#include "roomgraph/measures/Measure.h"

#include <algorithm>
#include <stdexcept>

#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {

Measure measureNamed(const std::string& name) {
  const MeasureKind* kind = findMeasureKind(name);
  if (!kind) throw std::logic_error("measure_kinds lacks " + name);
  Measure measure;
  measure.name = name, measure.unit = kind->unit;
  return measure;
}

Measure measureNamed(const std::string& name, std::optional<double> value, double support) {
  Measure measure = measureNamed(name);
  measure.value = value, measure.support = support;
  measure.isMeaningful = value && support >= findMeasureKind(name)->leastSupport;
  return measure;
}

const Measure* find(const std::vector<Measure>& measures, const std::string& name) {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == measures.end() ? nullptr : &*found;
}

}  // namespace roomgraph
