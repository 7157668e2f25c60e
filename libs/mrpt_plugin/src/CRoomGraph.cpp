#include "roomgraph/mrpt_plugin/CRoomGraph.h"

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/mrpt_plugin/graph_text.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/mrpt_plugin/scene_file.h"

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

std::string roomGraphBytes(const CRoomGraph& graph) {
  checkMapSize(graph);  // here, for MRPT's streams would wrap the message into a backtrace
  return gzippedObject(graph);
}

CRoomGraph loadRoomGraph(const std::string& path) {
  CRoomGraph graph;
  readObjectFile(path, kRoomGraphObject, [&](ByteView body) { readGraphBytes(body, path, graph); });
  return graph;
}

MrptScene graphScene(const CRoomGraph& graph) {
  MrptScene scene;
  scene.insert(drawGraph(graph));
  lookFromAbove(scene, drawnBox(graph));
  return scene;
}

std::string sceneBytes(const CRoomGraph& graph) { return gzippedObject(graphScene(graph)); }

}  // namespace roomgraph
