#pragma once
#include <optional>
#include <string>

#include "roomgraph/graph_files/GraphFile.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** What a room graph of MRPT holds. */
struct MappedGraph {
  GraphFile file;           ///< the graph and where it comes from
  std::optional<Grid> map;  ///< drawn under the graph; its frame is that of `file`
};

/** A room graph as MRPT's programs and streams know it: it can be saved, shown as text and drawn in
 *  3D. Registered as "roomgraph::CRoomGraph" by registerMrptClasses(), or by loading
 *  libroomgraph_mrpt.so. */
class CRoomGraph : public mrpt::serialization::CSerializable,
                   public viz::Visualizable,
                   public mrpt::Stringifyable,
                   public MappedGraph {
  DEFINE_SERIALIZABLE(CRoomGraph, roomgraph)

 public:
  CRoomGraph() = default;
  /** The result of an extraction, with its map. */
  explicit CRoomGraph(const Stages& stages);
  ~CRoomGraph() override = default;

  /** graphText() of `file`. */
  std::string asString() const override;
  /** Adds one object, drawGraph() of this, to `container`. */
  void getVisualizationInto(viz::CSetOfObjects& container) const override;
};

}  // namespace roomgraph
