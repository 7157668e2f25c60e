// Writes an empty map's graph as JSON and as MRPT's bytes: enough to see that both link.
#include <roomgraph/graph_files/graph_json.h>
#include <roomgraph/mrpt_plugin/register_classes.h>
#include <roomgraph/mrpt_plugin/room_graph_file.h>

int main() {
  roomgraph::registerMrptClasses();
  const std::string json = roomgraph::graphJson(roomgraph::Stages());
  const bool isJson = json.find("roomgraph/graph") != std::string::npos;
  return isJson && !roomgraph::roomGraphBytes(roomgraph::CRoomGraph()).empty() ? 0 : 1;
}
