#include "roomgraph/mrpt_plugin/CRoomGraph.h"

#include <algorithm>

#include "graph_bytes.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/mrpt_plugin/graph_text.h"

IMPLEMENTS_SERIALIZABLE(CRoomGraph, CSerializable, roomgraph)

namespace roomgraph {
namespace {

const char* const kStreamName = "room graph";

/** Reads what the stream claims to hold piece by piece: a false claim costs no memory. */
std::string readClaimed(mrpt::serialization::CArchive& in, std::uint64_t size) {
  constexpr std::uint64_t pieceSize = 1 << 20;
  std::string bytes;
  while (bytes.size() < size) {
    const auto piece = static_cast<std::size_t>(std::min(size - bytes.size(), pieceSize));
    bytes.resize(bytes.size() + piece);
    if (in.ReadBuffer(bytes.data() + bytes.size() - piece, piece) != piece)
      throw std::runtime_error("end of stream");
  }
  return bytes;
}

}  // namespace

CRoomGraph::CRoomGraph(const Stages& stages) : file(graphFile(stages)), map(stages.grid) {}

std::string CRoomGraph::asString() const { return graphText(file); }

void CRoomGraph::getVisualizationInto(viz::CSetOfObjects& container) const {
  container.insert(drawGraph(*this));
}

uint8_t CRoomGraph::serializeGetVersion() const { return kGraphBytesVersion; }

void CRoomGraph::serializeTo(mrpt::serialization::CArchive& out) const {
  const std::string bytes = graphBytes(*this);
  out << static_cast<std::uint64_t>(bytes.size());
  out.WriteBuffer(bytes.data(), bytes.size());
}

void CRoomGraph::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version) {
  if (version > kGraphBytesVersion)
    refuse(kStreamName, "its version " + std::to_string(version) + " is not known",
           "read it with a newer roomgraph");
  std::string bytes;
  try {
    bytes = readClaimed(in, in.ReadAs<std::uint64_t>());
  } catch (const std::exception&) {
    // MRPT's own message is a page with a backtrace.
    refuse(kStreamName, "it is cut short or damaged", "copy or save it again");
  }
  readGraphBytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, kStreamName,
                 *this);
}

}  // namespace roomgraph
