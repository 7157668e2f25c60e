#include "roomgraph/graph_files/graphml.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <limits>
#include <map>
#include <sstream>

#include "sample_stages.h"

namespace roomgraph {
namespace {

using Tree = boost::property_tree::ptree;

Tree parsedGraphml(const std::string& xml) {
  std::istringstream stream(xml);
  Tree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree;
}

/** The data of a node or edge by the id of their keys. */
std::map<std::string, std::string> dataOf(const Tree& element) {
  std::map<std::string, std::string> data;
  for (const auto& [name, child] : element)
    if (name == "data") data[child.get<std::string>("<xmlattr>.key")] = child.data();
  return data;
}

std::vector<Tree> elements(const Tree& top, const std::string& wanted) {
  std::vector<Tree> found;
  for (const auto& [name, child] : top.get_child("graphml.graph"))
    if (name == wanted) found.push_back(child);
  return found;
}

TEST(Graphml, holdsAllVerticesAndEdgesWithTheirIds) {
  const RoomGraph graph = sampleStages().result;
  const Tree top = parsedGraphml(graphml(graph));
  const auto nodes = elements(top, "node"), edges = elements(top, "edge");
  ASSERT_EQ(nodes.size(), graph.graph.vertices().size());
  ASSERT_EQ(edges.size(), graph.graph.edges().size());
  EXPECT_EQ(nodes[5].get<std::string>("<xmlattr>.id"), "n5");
  EXPECT_EQ(edges[4].get<std::string>("<xmlattr>.id"), "e4");
  EXPECT_EQ(edges[4].get<std::string>("<xmlattr>.source"), "n3");
  EXPECT_EQ(edges[4].get<std::string>("<xmlattr>.target"), "n4");
  EXPECT_EQ(top.get<std::string>("graphml.graph.<xmlattr>.edgedefault"), "undirected");
}

TEST(Graphml, saysWhatAThingIs) {
  const Tree top = parsedGraphml(graphml(sampleStages().result));
  auto room = dataOf(elements(top, "node")[0]), deadEnd = dataOf(elements(top, "node")[5]);
  EXPECT_EQ(room["kind"], "room");
  EXPECT_EQ(room["x"], "1.45");
  EXPECT_EQ(room["room"], "0");
  EXPECT_EQ(room["area"], "16.31");
  EXPECT_EQ(deadEnd["kind"], "dead_end");
  EXPECT_EQ(deadEnd.count("room"), 0u);
  EXPECT_EQ(deadEnd.count("area"), 0u);
  auto inside = dataOf(elements(top, "edge")[0]), corridor = dataOf(elements(top, "edge")[6]);
  EXPECT_EQ(inside["edge_kind"], "room");
  EXPECT_EQ(inside["length"], "2.05");
  EXPECT_EQ(corridor["edge_kind"], "corridor");
  EXPECT_EQ(corridor["min_clearance"], "0.3");
  EXPECT_EQ(corridor.count("edge_room"), 0u);
}

TEST(Graphml, declaresEveryKeyThatItUsesOnce) {
  const Tree top = parsedGraphml(graphml(sampleStages().result));
  std::map<std::string, std::string> keys;
  for (const auto& [name, child] : top.get_child("graphml")) {
    if (name != "key") continue;
    const auto id = child.get<std::string>("<xmlattr>.id");
    EXPECT_EQ(keys.count(id), 0u) << id;
    keys[id] = child.get<std::string>("<xmlattr>.for");
  }
  for (const char* kind : {"node", "edge"})
    for (const Tree& element : elements(top, kind))
      for (const auto& [key, value] : dataOf(element)) EXPECT_EQ(keys[key], kind) << key;
}

TEST(Graphml, leavesOutWhatIsUnbounded) {
  Stages stages = sampleStages();
  auto edges = stages.result.graph.edges();
  edges[0].path.minClearance = std::numeric_limits<double>::infinity();
  stages.result.graph = TopologyGraph(stages.result.graph.vertices(), edges);
  const Tree top = parsedGraphml(graphml(stages.result));
  EXPECT_EQ(dataOf(elements(top, "edge")[0]).count("min_clearance"), 0u);
}

TEST(Graphml, ofAnEmptyGraphIsAnEmptyGraph) {
  EXPECT_TRUE(elements(parsedGraphml(graphml({})), "node").empty());
}

}  // namespace
}  // namespace roomgraph
