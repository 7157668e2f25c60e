#include "roomgraph/measures/measure_kinds.h"

#include "measure_table.h"

namespace roomgraph {
namespace {

template <class Wanted>
std::vector<MeasureKind> kindsOf(const Wanted& isWanted) {
  std::vector<MeasureKind> kinds;
  for (const MeasureRow& row : measureTable())
    if (isWanted(row)) kinds.push_back(row.kind);
  return kinds;
}

}  // namespace

const std::vector<MeasureKind>& runMeasureKinds() {
  static const auto kinds = kindsOf([](const MeasureRow& row) { return bool(row.ofRun); });
  return kinds;
}

const std::vector<MeasureKind>& pairMeasureKinds() {
  static const auto kinds = kindsOf([](const MeasureRow& row) { return !row.ofRun; });
  return kinds;
}

const MeasureKind* findMeasureKind(const std::string& name) {
  for (const MeasureRow& row : measureTable())
    if (row.kind.name == name) return &row.kind;
  return nullptr;
}

}  // namespace roomgraph
