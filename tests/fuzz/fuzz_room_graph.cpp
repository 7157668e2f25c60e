// Any bytes as MRPT's file of a room graph, packed with the right checksum.
#include "ByteSource.h"
#include "as_file.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomgraph;
  test::ByteSource bytes(data, size);
  try {
    const CRoomGraph graph =
        loadRoomGraph(test::asFile(compressed(bytes.rest(), Compression::gzip)));
    loadRoomGraph(test::asFile(roomGraphBytes(graph)));
  } catch (const DataError&) {
  }
  return 0;
}
