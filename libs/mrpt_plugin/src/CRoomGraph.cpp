#include "roomgraph/mrpt_plugin/CRoomGraph.h"

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/mrpt_plugin/graph_text.h"

IMPLEMENTS_SERIALIZABLE(CRoomGraph, CSerializable, roomgraph)

namespace roomgraph {

CRoomGraph::CRoomGraph(const Stages& stages) : MappedGraph{graphFile(stages), stages.grid} {}

std::string CRoomGraph::asString() const { return graphText(file); }

void CRoomGraph::getVisualizationInto(viz::CSetOfObjects& container) const {
  container.insert(drawGraph(*this));
}

uint8_t CRoomGraph::serializeGetVersion() const { return kRoomGraphObject.newest; }

void CRoomGraph::serializeTo(mrpt::serialization::CArchive& out) const {
  putBody(out, graphBytes(*this));
}

void CRoomGraph::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version) {
  readBody(in, version, kRoomGraphObject,
           [&](ByteView body) { readGraphBytes(body, kRoomGraphObject.name, *this); });
}

}  // namespace roomgraph
