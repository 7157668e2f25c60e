// For the test of MRPT's viewers: writes the sample graph and prints the colours that must be seen,
// one a line, as "name red green blue".

#include <exception>
#include <iostream>

#include "roomgraph/files/write_file.h"
#include "roomgraph/mrpt_plugin/colors.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/mrpt_plugin/scene_file.h"
#include "roomgraph/topology/kind_names.h"
#include "sample_graph.h"

namespace {

void print(const std::string& name, roomgraph::Color color) {
  std::cout << name << " " << int(color.r) << " " << int(color.g) << " " << int(color.b) << "\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: write_sample FILE.roomgraph FILE.3Dscene\n";
    return 2;
  }
  const roomgraph::CRoomGraph sample = roomgraph::sampleGraph();
  roomgraph::saveRoomGraph(argv[1], sample);
  roomgraph::writeFileAtomically(argv[2], roomgraph::sceneBytes(sample));
  for (std::size_t room = 0; room < 4; ++room)
    print("floor_" + std::to_string(room), roomgraph::roomColor(room));
  print("corridor", roomgraph::kCorridorColor);
  for (const roomgraph::Vertex& vertex : sample.file.graph.graph.vertices())
    print(roomgraph::kindName(vertex.kind), roomgraph::vertexColor(vertex.kind));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
