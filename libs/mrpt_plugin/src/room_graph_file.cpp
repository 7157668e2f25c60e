#include "roomgraph/mrpt_plugin/room_graph_file.h"

#include "graph_bytes.h"
#include "object_bytes.h"
#include "roomgraph/files/checked_file.h"
#include "roomgraph/files/write_file.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

std::string roomGraphBytes(const CRoomGraph& graph) {
  checkMapSize(graph);  // here, for MRPT's streams would wrap the message into a backtrace
  return gzippedObject(graph);
}

void saveRoomGraph(const std::string& path, const CRoomGraph& graph) {
  writeFileAtomically(path, roomGraphBytes(graph));
}

CRoomGraph loadRoomGraph(const std::string& path) {
  CheckedFile file(path);
  const std::optional<ObjectHeader> head = peekObjectHeader(file.head());
  if (!head || head->className != "CRoomGraph")
    refuse(path, "is no room graph", "give a .roomgraph file");
  const ByteView content = file.content();
  ByteReader in(content, path);
  const ObjectHeader header = readObjectHeader(in);
  checkVersion(in, header, kGraphBytesVersion);
  const auto size = in.get<std::uint64_t>();
  const ByteView body{in.take(size), static_cast<std::size_t>(size)};
  readObjectEnd(in, header);
  if (in.left() > 0) refuse(path, "something follows the room graph in it", "save it again");
  CRoomGraph graph;
  readGraphBytes(body, path, graph);
  return graph;
}

}  // namespace roomgraph
