#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "goes_on.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/rooms/SplitAtDoorsOptions.h"
#include "roomgraph/topology/VoronoiGraph.h"
#include "roomgraph/topology/keep_inside.h"

namespace roomgraph {

/** A room behind one door may be this much longer than others before it is a corridor, and rooms in
 *  a row together this much longer than one. */
constexpr double kLongerThanOthers = 1.5;

/** Two obstacles face each other where they are nearly as far apart as the disc between them is
 *  wide: the cosine of a quarter of a right angle. */
constexpr double kFacing = 0.924;

/** Which end of an edge lies in a cubicle, if the edge leads through the front of one. */
enum class CubicleEnd : std::uint8_t { none, source, target };

/** The regions of the inside as they grow together. A region goes by its smallest vertex. */
class RegionGroups {
 public:
  /** The widest passages between two regions, and how many there are. */
  struct Passage {
    double clearance = 0;  // half of its width [m]
    double second = 0;     // of the next one; 0 where there is one only
    int count = 0;
    bool isOffCorridor = false;  // the widest, after findOpeningsOffCorridors
    bool isFront = false;        // the same, after keepFronts
    bool isOwnFront = false;     // and the region itself lies behind it
  };
  using Neighbours = std::vector<std::pair<std::uint32_t, Passage>>;        // by region
  using AllNeighbours = std::vector<std::pair<std::uint32_t, Neighbours>>;  // the same

  /** Each vertex is a region; they are joined by edges of at least `minClearance` only. Obstacles
   *  are cells, and reach `halfCell` beyond their centres [m]: all widths here are free of them, so
   *  that they do not depend on the map's resolution. */
  RegionGroups(const VoronoiGraph& voronoi, const InsideFlags& isInside, double minClearance,
               double halfCell, const SplitAtDoorsOptions& options = {});

  /** The edges between vertices inside, from wide to narrow; after keepPassages() those between
   *  different regions. */
  const std::vector<std::uint32_t>& edges() const { return edges_; }
  const VoronoiGraph& voronoi() const { return voronoi_; }
  const InsideFlags& isInside() const { return isInside_; }
  const SplitAtDoorsOptions& options() const { return options_; }
  UnionFind& groups() { return groups_; }

  std::uint32_t find(std::uint32_t vertex) { return groups_.find(vertex); }
  double clearance(const VoronoiEdge& edge) const {
    return std::max(0.0, edge.minClearance - halfCell_);
  }
  double halfCell() const { return halfCell_; }
  double radius(std::uint32_t region) const { return radius_[region]; }  // of the largest disc
  double area(std::uint32_t region) const { return area_[region]; }      // after sumAreas()
  /** Its area in squares round its largest disc: 1 for a square, large for a corridor. */
  double elongation(std::uint32_t region) const;

  /** Of two that with more area, width or wall, rounded: the map's pose must not decide. */
  std::uint32_t larger(std::uint32_t a, std::uint32_t b) const;  // after sumWalls()
  /** Whether it is as long and as narrow as a corridor. After sumAreas(). */
  bool isLong(std::uint32_t region) const;
  /** Whether it is too narrow for a room with a way out that is no door. */
  bool isNarrow(std::uint32_t region) const;
  /** Whether the two obstacles of an edge face each other. */
  bool isFacing(const VoronoiEdge& edge) const;
  /** A unit vector at right angles to these, from the source of an edge to its target. */
  Point across(const VoronoiEdge& edge) const;
  /** Whether the narrowest place of an edge is an opening, no wider than a door, in a wall that
   *  goes on at both of its ends. */
  bool isOpeningInWall(const VoronoiEdge& edge, const Grid& grid, WallTest& isIn = isInWall) const;
  /** The same in the side of a corridor. That may be as wide as what lies behind it, as a closet,
   *  or a room of which a beam has seen no more. */
  bool isOpeningOffCorridor(const VoronoiEdge& edge, const Grid& grid) const;

  /** How much of its area is nearest to walls, beside the mean where walls are. After sumWalls. */
  double wallShare(std::uint32_t region) const;
  /** The mean distance from its ways to the walls beside them, by the area there, twice [m]. A
   *  corridor is as wide as this, whatever opens into it. After sumWalls. */
  double meanWidth(std::uint32_t region) const;

  /** Per edge of the diagram. What meets at a front stays apart, but for leftovers. */
  void keepFronts(std::vector<CubicleEnd> fronts) { fronts_ = std::move(fronts); }
  bool isFront(std::uint32_t edge) const;

  void join(std::uint32_t a, std::uint32_t b);
  void sumAreas();
  /** `isWall`, per obstacle, tells walls from the edge of the unknown. Areas count, not
   *  obstacles: cells make an edge the more ragged the smaller they are. O(n). */
  void sumWalls(const std::vector<std::uint8_t>& isWall);
  void findOpeningsOffCorridors(const Grid& grid);
  /** Calls `visit(edge, end, area)` for each part of an edge from an end inside to its narrowest
   *  place. `area` lies between that and one of its two obstacles [m2]: both bound as much.
   *  O(n). */
  template <class Visit>
  void eachStretch(const Visit& visit) const {
    const auto isOutside = [&](std::uint32_t end) {
      return end == VoronoiEdge::kNoVertex || !isInside_[end];
    };
    for (const VoronoiEdge& edge : voronoi_.edges) {
      if (isOutside(edge.source) && isOutside(edge.target)) continue;
      const Point left = voronoi_.obstacles[edge.left], across = narrowest(edge) - left;
      for (const std::uint32_t end : {edge.source, edge.target})
        if (!isOutside(end))
          visit(edge, end, std::abs(cross(voronoi_.vertices[end].place - left, across)) / 2);
    }
  }
  /** Calls `visit` with each region, in ascending order. */
  template <class Visit>
  void eachRegion(const Visit& visit) {
    for (std::uint32_t v = 0; v < isInside_.size(); ++v)
      if (isInside_[v] && find(v) == v) visit(v);
  }
  /** Who meets whom where. O(passages). */
  AllNeighbours neighbours();

 private:
  void keepPassages();

  /** Where two areas meet: at the narrowest place of an edge. What lies behind the two obstacles is
   *  another space. */
  Point narrowest(const VoronoiEdge& edge) const;

  double halfCell_;
  SplitAtDoorsOptions options_;
  const VoronoiGraph& voronoi_;
  const InsideFlags& isInside_;
  std::vector<std::uint32_t> edges_;
  UnionFind groups_;
  std::vector<double> radius_, area_;
  std::vector<double> bounded_, walled_;  // areas nearest to obstacles, and to walls [m2]
  std::vector<double> widened_;           // the former times the clearance there [m3]
  double meanWallShare_ = 1;
  std::vector<std::uint8_t> isOffCorridor_;  // per edge of the diagram
  std::vector<CubicleEnd> fronts_;           // the same
};

/** Whether a passage is narrow beside both of its sides. */
bool isDoor(const RegionGroups& regions, double clearance, std::uint32_t a, std::uint32_t b,
            double maxRatio, double maxWidth);

}  // namespace roomgraph
