// Writes an empty graph as MRPT's bytes: enough to see that the classes link.
#include <roomgraph/mrpt_plugin/register_classes.h>
#include <roomgraph/mrpt_plugin/room_graph_file.h>

int main() {
  roomgraph::registerMrptClasses();
  return roomgraph::roomGraphBytes(roomgraph::CRoomGraph()).empty() ? 1 : 0;
}
