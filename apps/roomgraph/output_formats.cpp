#include "output_formats.h"

#include <sstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/draw.h"
#include "roomgraph/graph_files/area_pictures.h"
#include "roomgraph/graph_files/geojson.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/graphml.h"
#include "roomgraph/graph_files/osm_xml.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/mrpt_plugin/scene_file.h"

namespace roomgraph {
namespace {

/** Outlines may be off by half a cell: that much the map does not tell. */
OsmXmlOptions osmOptions(const Stages& stages, const AreaWishes& wishes) {
  OsmXmlOptions options;
  options.names = wishes.names;
  options.tolerance = stages.grid.frame.resolution / 2;
  return options;
}

constexpr OutputFormat kFormats[] = {
    {"json", "json",
     [](const Stages& stages, const AreaWishes& wishes) {
       GraphFile file = graphFile(stages);
       file.areaNames = wishes.names;
       return graphJson(file);
     }},
    {"svg", "svg", [](const Stages& stages, const AreaWishes&) { return drawSvg(stages); }},
    {"png", "png", [](const Stages& stages, const AreaWishes&) { return drawPng(stages); }},
    {"graphml", "graphml",
     [](const Stages& stages, const AreaWishes&) { return graphml(stages.result); }},
    {"geojson", "geojson",
     [](const Stages& s, const AreaWishes& wishes) {
       return geojson(s.result, ObstacleRows(s.obstacles), s.clearance, s.areas.passages,
                      wishes.names);
     }},
    {"3Dscene", "3Dscene",
     [](const Stages& s, const AreaWishes&) { return sceneBytes(CRoomGraph(s)); }},
    {"roomgraph", "roomgraph",
     [](const Stages& s, const AreaWishes&) { return roomGraphBytes(CRoomGraph(s)); }},
    {"labels", "areas.png",
     [](const Stages& stages, const AreaWishes&) {
       return areaLabelsPng(stages.areas, stages.grid.frame);
     },
     false},
    {"osm", "osm",
     [](const Stages& stages, const AreaWishes& wishes) {
       return osmXml(stages.areas, osmOptions(stages, wishes));
     },
     false},
    {"osm_ids", "ids.osm",
     [](const Stages& stages, const AreaWishes& wishes) {
       OsmXmlOptions options = osmOptions(stages, wishes);
       options.hasNumbers = true;
       return osmXml(stages.areas, options);
     },
     false},
    {"keepout", "keepout.png",
     [](const Stages& stages, const AreaWishes& wishes) {
       return keepoutMaskPng(stages.areas, stages.grid.frame, wishes.keptOut);
     },
     false, RosMapMode::trinary},
    {"speed", "speed.png",
     [](const Stages& stages, const AreaWishes&) {
       return speedMaskPng(stages.areas, stages.grid.frame);
     },
     false, RosMapMode::scale},
};

std::vector<std::string> allFormats() {
  return mapped(kFormats, [](const OutputFormat& format) { return std::string(format.name); });
}

}  // namespace

std::string listedFormats(const std::vector<std::string>& known,
                          const std::vector<std::string>& more) {
  std::vector<std::string> names = known;
  names.emplace_back("all");
  names.insert(names.end(), more.begin(), more.end());
  return alternatives(names);
}

std::vector<std::string> chosenFormats(const std::string& list,
                                       const std::vector<std::string>& known,
                                       const std::vector<std::string>& more) {
  std::vector<std::string> chosen;
  const auto add = [&](const std::string& name) {
    if (!contains(chosen, name)) chosen.push_back(name);
  };
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');) {
    if (name == "all")
      for (const std::string& each : known) add(each);
    else if (contains(known, name) || contains(more, name))
      add(name);
    else
      throw UsageError("there is no format '" + name + "': --format takes " +
                       listedFormats(known, more));
  }
  if (chosen.empty()) throw UsageError("--format is empty: it takes " + listedFormats(known, more));
  return chosen;
}

std::string formatNames() { return listedFormats(allFormats()); }

std::string defaultFormats() {
  std::string names;
  for (const OutputFormat& format : kFormats)
    if (format.isDefault) names += (names.empty() ? "" : ",") + std::string(format.name);
  return names;
}

std::vector<OutputFormat> parseFormats(const std::string& list) {
  std::vector<OutputFormat> formats;
  for (const std::string& name : chosenFormats(list, allFormats()))
    formats.push_back(*findIf(kFormats, [&](const OutputFormat& f) { return f.name == name; }));
  return formats;
}

}  // namespace roomgraph
