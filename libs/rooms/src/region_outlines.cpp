#include "roomgraph/rooms/region_outlines.h"

#include <utility>

#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

/** Gives faces without a region that of a neighbour, in rounds from the regions outwards. */
class FaceCover {
 public:
  FaceCover(const Grid& grid, const VoronoiGraph& voronoi, const InsideFlags& isInside,
            const Regions& regions)
      : voronoi_(voronoi),
        regionOf_(regions.regionOf),
        isHidden_(regionOf_.size()),
        best_(regionOf_.size()) {
    // What lies in free space and is not inside is outside.
    for (std::uint32_t v = 0; v < isHidden_.size(); ++v)
      isHidden_[v] = regionOf_[v] == Regions::kNone &&
                     (isInside[v] || !grid.isFree(voronoi.vertices[v].place));
  }

  std::vector<std::uint32_t> run() {
    collectEdges();
    while (spread()) {
    }
    return std::move(regionOf_);
  }

 private:
  struct Offer {
    double width = 0;  // of the opening
    std::uint32_t region = Regions::kNone;

    /** The wider one; of equal ones that of the larger region, which has the smaller number. */
    bool isBetter(const Offer& other) const {
      if (width > other.width * (1 + kSameWidth)) return true;
      return width >= other.width * (1 - kSameWidth) && region < other.region;
    }
  };

  void collectEdges() {
    for (const VoronoiEdge& edge : voronoi_.edges)
      if (!edge.isInfinite() && (isHidden_[edge.source] || isHidden_[edge.target]))
        edges_.push_back(&edge);
  }

  /** A face may take the region of a neighbour. */
  bool isOpenTo(std::uint32_t face, std::uint32_t neighbour) const {
    return isHidden_[face] && regionOf_[face] == Regions::kNone &&
           regionOf_[neighbour] != Regions::kNone;
  }

  /** One round: each face takes the region behind its widest opening. */
  bool spread() {
    std::vector<std::uint32_t> faces;  // that have an offer
    const auto offer = [&](const VoronoiEdge& edge, std::uint32_t to, std::uint32_t from) {
      if (!isOpenTo(to, from)) return;
      const Offer one{distance(voronoi_.obstacles[edge.left], voronoi_.obstacles[edge.right]),
                      regionOf_[from]};
      if (best_[to].region == Regions::kNone) faces.push_back(to);
      if (one.isBetter(best_[to])) best_[to] = one;
    };
    for (const VoronoiEdge* edge : edges_) {
      offer(*edge, edge->source, edge->target);
      offer(*edge, edge->target, edge->source);
    }
    for (const std::uint32_t face : faces) regionOf_[face] = best_[face].region;
    const auto isDone = [&](const VoronoiEdge* edge) {
      const auto isOpen = [&](std::uint32_t v) {
        return isHidden_[v] && regionOf_[v] == Regions::kNone;
      };
      return !isOpen(edge->source) && !isOpen(edge->target);
    };
    eraseIf(edges_, isDone);
    return !faces.empty();
  }

  const VoronoiGraph& voronoi_;
  std::vector<std::uint32_t> regionOf_;
  std::vector<std::uint8_t> isHidden_;
  std::vector<Offer> best_;  // per face, in the round in which it gets one
  std::vector<const VoronoiEdge*> edges_;
};

}  // namespace

Rooms RegionOutlines::worthAWay() const {
  Rooms worth = rooms();
  if (worth.empty()) return worth;
  const double usual = median(mapped(worth, [](const Room& room) { return area(room.polygon); }));
  for (std::uint32_t i = roomCount; i < seenCount; ++i)
    if (area(regions[i].polygon) >= usual) worth.push_back(regions[i]);
  return worth;
}

RegionOutlines regionOutlines(const Grid& grid, const VoronoiGraph& voronoi,
                              const InsideFlags& isInside, const Regions& regions,
                              const std::vector<std::uint8_t>& isWall) {
  RegionOutlines outlines;
  outlines.regions = traceRegions(voronoi, regions);
  outlines.roomCount = regions.roomCount;
  outlines.seenCount = regions.seenCount;
  const std::vector<std::uint32_t> cover = FaceCover(grid, voronoi, isInside, regions).run();
  for (const VoronoiEdge& edge : voronoi.edges) {
    const std::uint32_t source = cover[edge.source];
    const std::uint32_t target = edge.isInfinite() ? Regions::kNone : cover[edge.target];
    if (source == target) continue;
    const bool isOpening =
        regions.of(edge.source) != Regions::kNone && regions.of(edge.target) != Regions::kNone;
    // The source lies on the left of the way from the right site to the left one.
    outlines.borders.push_back({source, target, voronoi.obstacles[edge.right],
                                voronoi.obstacles[edge.left], isOpening ? edge.minClearance : 0,
                                (isWall[edge.right] ? 1 : 0) + (isWall[edge.left] ? 1 : 0)});
  }
  return outlines;
}

}  // namespace roomgraph
