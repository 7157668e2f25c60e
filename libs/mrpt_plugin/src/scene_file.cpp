#include "roomgraph/mrpt_plugin/scene_file.h"

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"

namespace roomgraph {

MrptScene graphScene(const CRoomGraph& graph) {
  MrptScene scene;
  scene.insert(drawGraph(graph));
  lookFromAbove(scene, drawnBox(graph));
  return scene;
}

std::string sceneBytes(const CRoomGraph& graph) { return gzippedObject(graphScene(graph)); }

}  // namespace roomgraph
