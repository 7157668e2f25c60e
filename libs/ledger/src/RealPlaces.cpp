#include "RealPlaces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

constexpr double kTile = 0.5;  // [m]

GridFrame tilesOf(const GridFrame& cells) {
  const auto count = [&](int of) { return int(of * cells.resolution / kTile) + 1; };
  return {count(cells.width), count(cells.height), kTile, cells.origin};
}

/** What a node has drawn in a tile. */
struct Drawn {
  std::size_t tile = 0;
  NodeId node;
};

/** The walls that each scan of a run has met, by tile and node. */
std::vector<Drawn> allDrawn(const std::vector<ScanWalls>& scans, const IdRange<NodeId>& nodes,
                            const GridFrame& tiles) {
  std::vector<Drawn> drawn;
  for (std::size_t k = 0; k < std::min(scans.size(), nodes.size()); ++k)
    for (const WallPoint& wall : scans[k].walls)
      if (const Cell tile = tiles.cellAt(wall.place); tiles.contains(tile))
        drawn.push_back({tiles.index(tile), nodes[k]});
  sortBy(drawn, [](const Drawn& one) { return std::make_pair(one.tile, one.node); });
  return drawn;
}

/** For each tile the node that has drawn most in it, or in the next one in which anything was. */
std::vector<NodeId> nodesOfTiles(const std::vector<Drawn>& drawn, const GridFrame& tiles) {
  std::vector<NodeId> nodes(tiles.cellCount());
  std::vector<std::size_t> open;
  std::size_t most = 0;
  for (std::size_t first = 0, end = 0; first < drawn.size(); first = end) {
    const auto [tile, node] = drawn[first];
    while (end < drawn.size() && drawn[end].tile == tile && drawn[end].node == node) ++end;
    if (!nodes[tile]) open.push_back(tile), most = 0;
    if (end - first > most) nodes[tile] = node, most = end - first;
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Cell tile{int(open[i]) % tiles.width, int(open[i]) / tiles.width};
    for (const Cell next : {Cell{tile.x - 1, tile.y}, Cell{tile.x + 1, tile.y},
                            Cell{tile.x, tile.y - 1}, Cell{tile.x, tile.y + 1}}) {
      if (!tiles.contains(next) || nodes[tiles.index(next)]) continue;
      nodes[tiles.index(next)] = nodes[open[i]];
      open.push_back(tiles.index(next));
    }
  }
  return nodes;
}

}  // namespace

RealPlaces::RealPlaces(const Site& site, const Consensus& consensus, const Transform2D& frame,
                       std::size_t run) {
  const RunId id = consensus.graphRuns[run];
  const std::size_t counted = id ? consensus.siteRuns[id] : run;
  copied_ = site.poses[counted].inverse() * site.poses[run];
  tiles_ = tilesOf(site.runs[counted]->map.frame);
  motions_.assign(tiles_.cellCount(), Motion2D(site.poses[run]));
  const std::vector<Drawn> drawn =
      allDrawn(site.runs[counted]->scans, consensus.nodesOf(run), tiles_);
  const std::vector<NodeId> nodeOf = nodesOfTiles(drawn, tiles_);
  for (std::size_t tile = 0; tile < motions_.size(); ++tile)
    if (const NodeId node = nodeOf[tile])
      motions_[tile] = Motion2D(frame * consensus.poses[node] *
                                consensus.graph.nodes[node].pose.inverse() * copied_);
}

const Motion2D& RealPlaces::at(Point place) const {
  const Cell tile = tiles_.cellAt(copied_(place));
  const Cell inside{std::clamp(tile.x, 0, tiles_.width - 1),
                    std::clamp(tile.y, 0, tiles_.height - 1)};
  return motions_[tiles_.index(inside)];
}

Transform2D frameOfConsensus(const Site& site, const Consensus& consensus, const Trust& trust) {
  std::optional<std::size_t> best;
  const auto rank = [&](std::size_t i) {
    return std::make_pair(-trust[i], consensus.errorOf(i).error);
  };
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (!site.runs[i]->scans.empty() && consensus.isCounted(i) && (!best || rank(i) < rank(*best)))
      best = i;
  MotionFit fit;
  if (best)
    for (const NodeId node : consensus.nodesOf(*best))
      fit.add(consensus.poses[node].shift(),
              site.poses[*best](consensus.graph.nodes[node].pose.shift()));
  return fit.motion();
}

}  // namespace roomgraph
