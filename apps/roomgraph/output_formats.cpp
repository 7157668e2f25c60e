#include "output_formats.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/mrpt_plugin/scene_file.h"
#include "roomgraph/report/draw.h"
#include "roomgraph/report/geojson.h"
#include "roomgraph/report/graph_json.h"
#include "roomgraph/report/graphml.h"

namespace roomgraph {
namespace {

constexpr OutputFormat kFormats[] = {
    {"json", [](const Stages& stages) { return graphJson(stages); }},
    {"svg", drawSvg},
    {"png", drawPng},
    {"graphml", [](const Stages& stages) { return graphml(stages.result); }},
    {"geojson", [](const Stages& stages) { return geojson(stages.result); }},
    {"3Dscene", [](const Stages& stages) { return sceneBytes(CRoomGraph(stages)); }},
    {"roomgraph", [](const Stages& stages) { return roomGraphBytes(CRoomGraph(stages)); }},
};

bool sameName(const OutputFormat& format, const std::string& name) { return name == format.name; }

}  // namespace

std::string formatNames() {
  std::string names;
  for (const OutputFormat& format : kFormats) names += std::string(format.name) + ", ";
  return names.substr(0, names.size() - 2) + " or all";
}

std::vector<OutputFormat> parseFormats(const std::string& list) {
  std::vector<OutputFormat> formats;
  const auto add = [&](const OutputFormat& format) {
    for (const OutputFormat& known : formats)
      if (sameName(known, format.name)) return;
    formats.push_back(format);
  };
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');) {
    if (name == "all") {
      for (const OutputFormat& format : kFormats) add(format);
      continue;
    }
    const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                     [&](const OutputFormat& f) { return sameName(f, name); });
    if (found == std::end(kFormats))
      throw UsageError("there is no format '" + name + "': --format takes " + formatNames());
    add(*found);
  }
  if (formats.empty()) throw UsageError("--format is empty: it takes " + formatNames());
  return formats;
}

}  // namespace roomgraph
