#include "roomgraph/graph_files/osm_xml.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <map>
#include <set>
#include <sstream>

#include "sample_stages.h"

namespace roomgraph {
namespace {

using Tree = boost::property_tree::ptree;
using Tags = std::map<std::string, std::string>;

struct Way {
  std::vector<long> nodes;
  Tags tags;
};

struct Relation {
  std::vector<std::pair<std::string, long>> members;
  Tags tags;
};

/** The file again; every id that occurs twice is an error. */
struct Osm {
  std::map<long, std::pair<double, double>> nodes;  // latitude, longitude
  std::map<long, Tags> nodeTags;
  std::map<long, Way> ways;
  std::map<long, Relation> relations;

  const Way& named(const std::string& name) const {
    for (const auto& [id, way] : ways)
      if (way.tags.count("name") && way.tags.at("name") == name) return way;
    throw std::runtime_error("no way is called " + name);
  }
};

Tags tagsOf(const Tree& element) {
  Tags tags;
  for (const auto& [name, child] : element)
    if (name == "tag")
      tags[child.get<std::string>("<xmlattr>.k")] = child.get<std::string>("<xmlattr>.v");
  return tags;
}

Way wayOf(const Tree& element) {
  Way way{{}, tagsOf(element)};
  for (const auto& [name, child] : element)
    if (name == "nd") way.nodes.push_back(child.get<long>("<xmlattr>.ref"));
  return way;
}

Relation relationOf(const Tree& element) {
  Relation relation{{}, tagsOf(element)};
  for (const auto& [name, child] : element)
    if (name == "member")
      relation.members.emplace_back(child.get<std::string>("<xmlattr>.role"),
                                    child.get<long>("<xmlattr>.ref"));
  return relation;
}

Osm parsed(const std::string& xml) {
  std::istringstream stream(xml);
  Tree top;
  boost::property_tree::read_xml(stream, top);
  Osm osm;
  bool isNew = true;
  for (const auto& [kind, element] : top.get_child("osm")) {
    if (kind == "<xmlattr>") continue;
    const long id = element.get<long>("<xmlattr>.id");
    EXPECT_LT(id, 0);
    if (kind == "node") {
      isNew = osm.nodes
                  .emplace(id, std::pair{element.get<double>("<xmlattr>.lat"),
                                         element.get<double>("<xmlattr>.lon")})
                  .second;
      osm.nodeTags[id] = tagsOf(element);
    } else if (kind == "way") {
      isNew = osm.ways.emplace(id, wayOf(element)).second;
    } else {
      isNew = osm.relations.emplace(id, relationOf(element)).second;
    }
    EXPECT_TRUE(isNew) << kind << " " << id;
  }
  return osm;
}

/** The nodes of an area's ways, its holes among them. */
std::set<long> ringNodes(const Osm& osm, const std::string& name) {
  const std::vector<long>& outer = osm.named(name).nodes;
  std::set<long> nodes(outer.begin(), outer.end());
  for (const auto& [id, relation] : osm.relations) {
    if (&osm.ways.at(relation.members.at(0).second) != &osm.named(name)) continue;
    for (const auto& [role, way] : relation.members)
      nodes.insert(osm.ways.at(way).nodes.begin(), osm.ways.at(way).nodes.end());
  }
  return nodes;
}

TEST(OsmXml, everyReferenceExistsAndEveryNodeIsUsed) {
  for (const Stages& stages : {sampleStages(), extractedStages()}) {
    const Osm osm = parsed(osmXml(stages.areas));
    std::set<long> used{-1};
    for (const auto& [id, way] : osm.ways)
      for (const long node : way.nodes) {
        EXPECT_EQ(osm.nodes.count(node), 1u) << node;
        used.insert(node);
      }
    EXPECT_EQ(used.size(), osm.nodes.size());
    for (const auto& [id, relation] : osm.relations)
      for (const auto& [role, way] : relation.members) EXPECT_EQ(osm.ways.count(way), 1u) << way;
  }
}

TEST(OsmXml, areasAreClosedWaysWithTheTagsOfOsmag) {
  const Stages stages = sampleStages();
  const Osm osm = parsed(osmXml(stages.areas));
  const Tags room{{"height", "0"},       {"indoor", "room"},         {"level", "0"},
                  {"name", "room_0"},    {"osmAG:areaType", "room"}, {"osmAG:parent", "floor_0"},
                  {"osmAG:type", "area"}};
  const Tags corridor{
      {"height", "0"},        {"indoor", "corridor"},         {"level", "0"},
      {"name", "corridor_2"}, {"osmAG:areaType", "corridor"}, {"osmAG:parent", "floor_0"},
      {"osmAG:type", "area"}};
  EXPECT_EQ(osm.ways.at(-1).tags, room);
  EXPECT_EQ(osm.ways.at(-3).tags, corridor);
  for (const long id : {-1, -2, -3}) {
    EXPECT_EQ(osm.ways.at(id).nodes.front(), osm.ways.at(id).nodes.back());
    EXPECT_GE(osm.ways.at(id).nodes.size(), 5u);
  }
}

TEST(OsmXml, passagesEndInNodesOfBothTheirAreas) {
  const Stages stages = extractedStages();
  const Osm osm = parsed(osmXml(stages.areas));
  ASSERT_FALSE(stages.areas.passages.empty());
  std::size_t count = 0;
  for (const auto& [id, way] : osm.ways) {
    if (way.tags.count("osmAG:type") == 0 || way.tags.at("osmAG:type") != "passage") continue;
    ++count;
    ASSERT_EQ(way.nodes.size(), 2u);
    for (const char* key : {"osmAG:from", "osmAG:to"}) {
      const std::set<long> ring = ringNodes(osm, way.tags.at(key));
      for (const long node : way.nodes) EXPECT_EQ(ring.count(node), 1u) << way.tags.at(key);
    }
  }
  EXPECT_EQ(count, stages.areas.passages.size());
}

TEST(OsmXml, doorsToUnseenSpaceJoinNothing) {
  Stages stages = sampleStages();
  const std::size_t before = parsed(osmXml(stages.areas)).ways.size();
  stages.areas.passages[1].b = AreaId::none();
  const Osm osm = parsed(osmXml(stages.areas));
  EXPECT_EQ(osm.ways.size(), before - 1);
  EXPECT_EQ(osm.named("passage_0").tags.at("osmAG:to"), "room_1");
}

TEST(OsmXml, passagesSayWhatTheyJoin) {
  const Way passage = parsed(osmXml(sampleStages().areas)).named("passage_1");
  EXPECT_EQ(passage.tags, (Tags{{"level", "0"},
                                {"name", "passage_1"},
                                {"osmAG:from", "room_1"},
                                {"osmAG:to", "corridor_2"},
                                {"osmAG:type", "passage"},
                                {"roomgraph:confidence", "0"},
                                {"roomgraph:evidence", "narrowing"},
                                {"width", "0.9552"}}));
}

TEST(OsmXml, passagesSayHowSureTheyAreAndWhy) {
  const Way passage = parsed(osmXml(sampleStages().areas)).named("passage_0");
  EXPECT_EQ(passage.tags.at("roomgraph:confidence"), "0.8765");
  EXPECT_EQ(passage.tags.at("roomgraph:evidence"), "wall_on_both_sides");
}

TEST(OsmXml, theFloorIsAStructureRoundAllAreas) {
  const Osm osm = parsed(osmXml(sampleStages().areas));
  const Way& floor = osm.named("floor_0");
  EXPECT_EQ(floor.tags, (Tags{{"height", "0"},
                              {"indoor", "level"},
                              {"level", "0"},
                              {"name", "floor_0"},
                              {"osmAG:areaType", "structure"},
                              {"osmAG:type", "area"}}));
  EXPECT_EQ(floor.nodes.front(), floor.nodes.back());
  EXPECT_GE(floor.nodes.size(), 5u);
}

/** What osmAG's planner reads: numbers of ways that exist. */
TEST(OsmXml, withNumbersAllReferencesAreIdsOfAreas) {
  OsmXmlOptions options;
  options.hasNumbers = true;
  const Osm osm = parsed(osmXml(sampleStages().areas, options));
  int count = 0;
  for (const auto& [id, way] : osm.ways)
    for (const char* key : {"osmAG:from", "osmAG:to", "osmAG:parent"}) {
      if (way.tags.count(key) == 0) continue;
      ++count;
      EXPECT_EQ(osm.ways.at(std::stol(way.tags.at(key))).tags.at("osmAG:type"), "area");
      if (key != std::string("osmAG:parent")) continue;
      EXPECT_EQ(osm.ways.at(std::stol(way.tags.at(key))).tags.at("name"), "floor_0");
    }
  EXPECT_EQ(count, 3 + 2 * 2);
}

TEST(OsmXml, outlinesHaveNoMoreCornersThanHalfACellNeeds) {
  AreaGraph graph;
  Polygon stairs;  // a slanted wall, cell by cell
  for (int i = 0; i < 40; ++i) stairs.outer.push_back({0.1 * i, 0.05 * (i % 2)});
  stairs.outer.insert(stairs.outer.end(), {{4, 4}, {0, 4}});
  graph.areas = {{RoomId(0), stairs, {2, 2}, 1.9, {}}};
  OsmXmlOptions options;
  EXPECT_EQ(parsed(osmXml(graph, options)).named("room_0").nodes.size(), 43u);
  options.tolerance = 0.05;
  EXPECT_LE(parsed(osmXml(graph, options)).named("room_0").nodes.size(), 10u);
}

TEST(OsmXml, holesAreInnerMembersOfARelation) {
  const Osm osm = parsed(osmXml(sampleStages().areas));
  ASSERT_EQ(osm.relations.size(), 1u);
  const Relation& relation = osm.relations.at(-1);
  EXPECT_EQ(relation.tags, (Tags{{"type", "multipolygon"}}));
  ASSERT_EQ(relation.members.size(), 2u);
  EXPECT_EQ(relation.members[0], (std::pair<std::string, long>{"outer", -1}));
  EXPECT_EQ(relation.members[1].first, "inner");
  const Way& hole = osm.ways.at(relation.members[1].second);
  EXPECT_EQ(hole.nodes.size(), 5u);
  EXPECT_EQ(hole.nodes.front(), hole.nodes.back());
  EXPECT_TRUE(hole.tags.empty());
}

TEST(OsmXml, nodesLieInMetresRoundTheRoot) {
  const Osm osm = parsed(osmXml(sampleStages().areas));
  EXPECT_EQ(osm.nodeTags.at(-1), (Tags{{"name", "root"}}));
  EXPECT_EQ(osm.nodes.at(-1), (std::pair{0.0, 0.0}));
  // The first corner of the first room. A degree on the equator is 111.32 km east, 110.574 north.
  const auto [latitude, longitude] = osm.nodes.at(osm.ways.at(-1).nodes.front());
  EXPECT_NEAR(longitude * 111319.49, -0.55, 2e-4);
  EXPECT_NEAR(latitude * 110574.28, -1.55, 2e-4);
}

TEST(OsmXml, cornersOnAStraightLineAreLeftOutButForTheEndsOfPassages) {
  AreaGraph graph;
  const Polygon left{{{0, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 2}, {4, 3}, {4, 4}, {0, 4}}, {}};
  const Polygon right{{{4, 1}, {8, 1}, {8, 2}, {4, 2}}, {}};
  graph.areas = {{RoomId(0), left, {2, 2}, 2, {PassageId(0)}},
                 {RoomId::none(), right, {6, 1.5}, 0.5, {PassageId(0)}}};
  graph.passages = {{AreaId(0), AreaId(1), {4, 2}, {4, 1}, 1}};
  const Osm osm = parsed(osmXml(graph));
  EXPECT_EQ(osm.named("room_0").nodes.size(), 7u);
  EXPECT_EQ(osm.named("corridor_1").nodes.size(), 5u);
  EXPECT_EQ(osm.nodes.size(), 1u + 4u + 4u);
}

TEST(OsmXml, theRootOfAFarMapIsInItsMidst) {
  AreaGraph graph;
  for (const double x : {99990.0, 5400000.0}) {
    const Polygon room{{{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}}, {}};
    graph.areas = {{RoomId(0), room, {x + 2, 2}, 2, {}}};
    const Osm osm = parsed(osmXml(graph));
    const Tags near{{"name", "root"}};
    const Tags far{{"name", "root"}, {"roomgraph:x", "5400002"}, {"roomgraph:y", "2"}};
    EXPECT_EQ(osm.nodeTags.at(-1), x > 1e5 ? far : near);
    EXPECT_NEAR(osm.nodes.at(-2).second, (x > 1e5 ? -2 : x) / 111319.5, 1e-5);
  }
}

TEST(OsmXml, ofNoAreasIsTheRootAlone) {
  const Osm osm = parsed(osmXml({}));
  EXPECT_EQ(osm.nodes.size(), 1u);
  EXPECT_TRUE(osm.ways.empty());
}

}  // namespace
}  // namespace roomgraph
