#pragma once
#include <map>
#include <string>
#include <vector>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/geometry/Point.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** The walls of runs, by name: the middles of their wall cells [m, frame of the run]. */
using RunWalls = std::map<std::string, std::vector<Point>>;

/** What a comparison of MRPT holds. */
struct MappedComparison {
  Comparison comparison;
  RunWalls walls;  ///< of its runs; those without are not drawn
};

/** A comparison of maps as MRPT's programs and streams know it: it can be saved, shown as text and
 *  drawn in 3D. Registered as "roomgraph::CMapComparison" by registerMrptClasses(), or by loading
 *  libroomgraph_mrpt.so. */
class CMapComparison : public mrpt::serialization::CSerializable,
                       public viz::Visualizable,
                       public mrpt::Stringifyable,
                       public MappedComparison {
  DEFINE_SERIALIZABLE(CMapComparison, roomgraph)

 public:
  CMapComparison() = default;
  /** A comparison with the maps of its runs. */
  CMapComparison(Comparison compared, const std::vector<Run>& runs);
  ~CMapComparison() override = default;

  /** The verdict, the ranking, and where runs break. */
  std::string asString() const override;
  /** Adds one set of objects, named "comparison", to `container`: for each run a set with its name
   *  and its pose, its walls in the colour that it has in the report; then "rooms", "room names",
   *  "breaks" (rings with the key frame) and "legend". */
  void getVisualizationInto(viz::CSetOfObjects& container) const override;
};

}  // namespace roomgraph
