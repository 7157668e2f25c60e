// For the test of MRPT's viewers: writes a sample graph or comparison and prints the colours that
// must be seen, one a line, as "name red green blue".

#include <exception>
#include <iostream>

#include "roomgraph/base/write_file.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/mrpt_plugin/map_comparison_file.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/mrpt_plugin/scene_file.h"
#include "roomgraph/topology/kind_names.h"
#include "sample_graph.h"
#include "sample_map_comparison.h"

namespace {

void print(const std::string& name, roomgraph::Colour colour) {
  std::cout << name << " " << int(colour.red) << " " << int(colour.green) << " " << int(colour.blue)
            << "\n";
}

void writeGraph(const std::string& object, const std::string& scene) {
  const roomgraph::CRoomGraph sample = roomgraph::sampleGraph();
  roomgraph::writeFileAtomically(object, roomgraph::roomGraphBytes(sample));
  roomgraph::writeFileAtomically(scene, roomgraph::sceneBytes(sample));
  for (std::size_t room = 0; room < 4; ++room)
    print("floor_" + std::to_string(room), roomgraph::roomColour(room));
  print("corridor", roomgraph::kCorridorColour);
  for (const roomgraph::Vertex& vertex : sample.file.graph.graph.vertices())
    print(roomgraph::nameOf(vertex.kind), roomgraph::vertexColour(vertex.kind));
}

void writeComparison(const std::string& object, const std::string& scene) {
  const roomgraph::CMapComparison sample = roomgraph::test::sampleMapComparison();
  roomgraph::writeFileAtomically(object, roomgraph::mapComparisonBytes(sample));
  std::vector<roomgraph::Run> runs;
  for (const auto& [name, walls] : sample.walls) {
    roomgraph::WallMap& map = runs.emplace_back().map;
    runs.back().name = name;
    map.frame = {81, 81, 0.05, {-0.025, -0.025}};
    map.states.assign(map.frame.cellCount(), roomgraph::State::free);
    for (const roomgraph::Point wall : walls)
      map.states[map.frame.index(map.frame.cellAt(wall))] = roomgraph::State::occupied;
  }
  roomgraph::writeFileAtomically(scene, roomgraph::comparisonSceneBytes(sample.comparison, runs));
  for (std::size_t run = 0; run < 2; ++run) {
    const roomgraph::Colour c = roomgraph::runColour(run);
    print("run_" + std::to_string(run), {c.red, c.green, c.blue});
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::cerr << "usage: write_sample Graph|Comparison FILE.roomgraph FILE.3Dscene\n";
    return 2;
  }
  (std::string(argv[1]) == "Graph" ? writeGraph : writeComparison)(argv[2], argv[3]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
