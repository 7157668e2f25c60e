#pragma once
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include "roomgraph/topology/TopologyGraph.h"

namespace roomgraph {

/** A place on a path of a graph. */
struct PlaceOnPath {
  EdgeId edge;
  double along = 0;  ///< from the path's source [m]
};

/** The shortest ways from one place to all vertices that given edges reach, by Dijkstra's
 *  algorithm. Keeps a reference to the graph. O(n log n). */
class ShortestWays {
 public:
  /** Edges, and pieces of the first one, with less than `minClearance` are left out [m]. */
  ShortestWays(const TopologyGraph& graph, const std::vector<EdgeId>& edges, PlaceOnPath start,
               double minClearance = 0);

  [[nodiscard]] bool reaches(VertexId v) const { return best_.count(v) > 0; }
  /** `v` must be reached. */
  [[nodiscard]] Path pathTo(VertexId v) const;

 private:
  struct Way {
    double length;
    HalfEdgeId last;  // none where `first` leads all the way
    Path first;
  };
  using Entry = std::tuple<double, VertexId>;

  void offer(VertexId v, double length, HalfEdgeId last, Path first);
  void run();

  const TopologyGraph& graph_;
  std::map<VertexId, std::vector<HalfEdgeId>> ways_;
  std::map<VertexId, Way> best_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open_;
};

}  // namespace roomgraph
