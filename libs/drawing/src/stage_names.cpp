#include "roomgraph/drawing/stage_names.h"

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

std::vector<bool> finiteEdges(const Stages& stages) {
  return mapped(stages.voronoi.edges, std::not_fn(&VoronoiEdge::isInfinite));
}

std::vector<bool> insideEdges(const Stages& stages) {
  std::vector<bool> isInside = finiteEdges(stages);
  for (std::size_t e = 0; e < isInside.size(); ++e) {
    const VoronoiEdge& edge = stages.voronoi.edges[e];
    if (isInside[e]) isInside[e] = stages.isInside[edge.source] && stages.isInside[edge.target];
  }
  return isInside;
}

std::vector<bool> clearEdges(const Stages& stages) {
  std::vector<bool> isClear(stages.voronoi.edges.size());
  for (const auto e : stages.clearEdges) isClear[e] = true;
  return isClear;
}

}  // namespace

const std::vector<StageName>& stageNames() {
  static const std::vector<StageName> names = {
      {"grid", "IV-C", "free, occupied and unknown cells"},
      {"obstacles", "IV-C, III-A", "obstacle cells after thinning"},
      {"voronoi", "III-A", "Voronoi diagram of the obstacles", nullptr, finiteEdges},
      {"inside", "III-A", "without what lies outside", nullptr, insideEdges},
      {"clear", "III-A", "without what is too near to an obstacle", nullptr, clearEdges},
      {"topology", "III-A", "runs of Voronoi edges joined to paths", &Stages::topology},
      {"pruned", "III-A", "without dead ends that lead nowhere", &Stages::pruned},
      {"joined", "III-A", "near vertices joined", &Stages::joinedUp},
      {"kept", "III-A", "connected parts that are kept", &Stages::kept},
      {"rooms", "III-B", "rooms, the inner polygons of the alpha shape"},
      {"border_vertices", "III-C", "where paths cross the rooms' polygons"},
      {"cut", "III-D, III-E", "paths cut at the border vertices, with room ids", &Stages::cut},
      {"cleaned", "III-F", "without short dead ends at rooms", &Stages::cleaned},
      {"doors", "ours", "doors between two rooms joined to one vertex", &Stages::doors},
      {"result", "III-G", "the room graph"},
      {"areas", "ours", "rooms, pieces of corridor and passages"}};
  return names;
}

std::vector<Point> crossings(const Stages& stages) {
  std::vector<Point> places;
  for (std::size_t e = 0; e < stages.stretches.size(); ++e)
    for (std::size_t s = 1; s < stages.stretches[e].size(); ++s)
      places.push_back(pointAt(stages.kept.edges()[e].path.points, stages.stretches[e][s].from));
  return places;
}

}  // namespace roomgraph
