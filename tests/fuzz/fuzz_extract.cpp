// Any map with any options: extracts it, holds the result against its rules, writes all formats and
// reads the graph back.
#include <cstdio>
#include <cstdlib>

#include "graph_rules.h"
#include "odd_maps.h"
#include "roomgraph/graph_files/area_pictures.h"
#include "roomgraph/graph_files/geojson.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/graphml.h"
#include "roomgraph/graph_files/osm_xml.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/pipeline/extract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomgraph;
  test::ByteSource bytes(data, size);
  const ExtractOptions options = test::oddOptions(bytes);
  const Stages stages = extract(test::oddMap(bytes), options);
  const std::vector<std::string> broken = test::brokenRules(stages);
  for (const std::string& rule : broken) std::fprintf(stderr, "%s\n", rule.c_str());
  if (!broken.empty()) std::abort();
  graphml(stages.result),
      geojson(stages.result, ObstacleRows(stages.obstacles), stages.clearance,
              stages.areas.passages),
      osmXml(stages.areas);
  areaLabelsPng(stages.areas, stages.grid.frame);
  const std::string json = graphJson(stages);
  if (graphJson(parseGraphJson(json, "odd")) != json) std::abort();
  return 0;
}
