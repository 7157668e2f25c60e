#include "roomgraph/measures/measure_kinds.h"

#include "measure_table.h"

namespace roomgraph {

const std::vector<MeasureKind>& runMeasureKinds() {
  static const auto kinds = [] {
    std::vector<MeasureKind> ofRuns;
    for (const MeasureRow& row : measureTable())
      if (row.ofRun) ofRuns.push_back(row.kind);
    return ofRuns;
  }();
  return kinds;
}

const MeasureKind* findMeasureKind(const std::string& name) {
  for (const MeasureRow& row : measureTable())
    if (row.kind.name == name) return &row.kind;
  return nullptr;
}

}  // namespace roomgraph
