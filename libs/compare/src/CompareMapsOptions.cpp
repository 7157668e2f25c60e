#include "roomgraph/base/file_name.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {

FieldTable describe(CompareMapsOptions& options) {
  FieldTable table = describe(options.extract);
  table.flag("compare", "aligned", options.compare.areAligned,
             "All maps are in one frame already.");
  table.flag("compare", "estimate_scale", options.estimatesScale,
             "Bare pictures are read at the scale at which they fit the other maps.");
  table.count("compare", "core", options.compare.core, 3, 10000,
              "With more runs than this, only a core of this many is compared pair by pair, and "
              "the others with parts of it.");
  table.number("run_score", "scale", options.compare.scoreScale, "m", 0.001, 1000,
               "The map error at which the score is 37, which is 100 / e.");
  table.number("run_score", "min_share", options.compare.leastShare, "", 0, 1,
               "A score is meaningful only if other maps also have at least this share of the "
               "run's walls.");
  table.number("site_breaks", "min_shift", options.compare.breakShift, "m", 0.05, 100,
               "A run whose map jumps by this or more breaks there.");
  table.number("site_breaks", "min_rotation", options.compare.breakRotation, "rad", 0.005, 4,
               "The same where it turns by this or more.");
  return table;
}

void setUsed(const Comparison& comparison, FieldTable& table) {
  for (const UsedOption& used : comparison.options)
    for (const Field& field : table.fields())
      if (field.section == used.section && field.name == used.name)
        table.set(used.section, used.name, used.value);
}

std::vector<UsedOption> usedOptions(CompareMapsOptions options) {
  std::vector<UsedOption> used;
  const FieldTable table = describe(options);
  for (const Field& field : table.fields())
    used.push_back({field.section, field.name, valueText(field), field.unit, field.sentence});
  used.push_back({"compare", "reference", fileName(options.reference), "",
                  "The map that all runs are measured against; empty for none."});
  return used;
}

}  // namespace roomgraph
