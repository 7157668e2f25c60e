#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/CRoomGraph.h"

namespace roomgraph {

// In:   CRoomGraph
// Out:  the bytes of a .3Dscene file
// Next: writeFileAtomically

/** The graph as a scene whose camera looks at all of it from above, slightly tilted. */
[[nodiscard]] MrptScene graphScene(const CRoomGraph& graph);

/** The bytes of a `.3Dscene` file for SceneViewer3D; the same graph gives the same bytes. */
[[nodiscard]] std::string sceneBytes(const CRoomGraph& graph);

}  // namespace roomgraph
