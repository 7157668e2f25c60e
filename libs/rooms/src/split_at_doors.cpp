#include "roomgraph/rooms/split_at_doors.h"

#include <algorithm>
#include <map>

#include "roomgraph/base/UnionFind.h"

namespace roomgraph {
namespace {

/** Widths that differ by less than this share are equal: rounding must not decide. */
constexpr double kSame = 1e-9;

/** The edges inside, from wide to narrow. */
std::vector<std::uint32_t> edgesByWidth(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                                        double minClearance) {
  std::vector<std::uint32_t> edges;
  for (std::uint32_t e = 0; e < voronoi.edges.size(); ++e) {
    const VoronoiEdge& edge = voronoi.edges[e];
    if (!edge.isInfinite() && isInside[edge.source] && isInside[edge.target] &&
        edge.minClearance >= minClearance)
      edges.push_back(e);
  }
  std::stable_sort(edges.begin(), edges.end(), [&](std::uint32_t a, std::uint32_t b) {
    return voronoi.edges[a].minClearance > voronoi.edges[b].minClearance;
  });
  return edges;
}

/** Regions as they grow, merge and get their kinds. A region goes by the number of its first
 *  vertex. */
class Splitter {
 public:
  Splitter(const VoronoiGraph& voronoi, const InsideFlags& isInside, double minClearance,
           const SplitAtDoorsOptions& options)
      : voronoi_(voronoi),
        isInside_(isInside),
        options_(options),
        edges_(edgesByWidth(voronoi, isInside, minClearance)),
        groups_(voronoi.vertices.size()) {
    for (const VoronoiVertex& vertex : voronoi.vertices) radius_.push_back(vertex.clearance);
  }

  Regions run() {
    for (const std::uint32_t e : edges_) meet(voronoi_.edges[e]);
    sumAreas();
    while (absorbNiches()) {
    }
    return rooms();
  }

 private:
  /** The widest passage between two regions, and how many there are. */
  struct Passage {
    double width = 0;  // half of it, as clearance
    Point at;
    int count = 0;
  };
  using Neighbours = std::map<std::uint32_t, Passage>;

  bool isDoor(double passage, std::uint32_t a, std::uint32_t b) const {
    const double narrower = std::min(radius_[a], radius_[b]);
    return passage < options_.maxRatio * narrower * (1 - kSame) &&
           passage < options_.maxWidth / 2 && narrower >= options_.minSideWidth / 2 * (1 - kSame);
  }

  bool isNarrowBeside(std::uint32_t a, std::uint32_t b) const {
    return radius_[a] < options_.nicheRatio * radius_[b] * (1 - kSame);
  }

  void meet(const VoronoiEdge& edge) {
    const auto a = groups_.find(edge.source), b = groups_.find(edge.target);
    if (a == b || isDoor(edge.minClearance, a, b) || isNarrowBeside(a, b) || isNarrowBeside(b, a))
      return;
    join(a, b);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const double radius = std::max(radius_[a], radius_[b]);
    const double area = area_.empty() ? 0 : area_[a] + area_[b];
    groups_.join(a, b);
    const auto both = groups_.find(a);
    radius_[both] = radius;
    if (!area_.empty()) area_[both] = area;
  }

  /** From here on only the edges between regions matter. */
  void keepPassages() {
    const auto isInner = [&](std::uint32_t e) {
      return groups_.find(voronoi_.edges[e].source) == groups_.find(voronoi_.edges[e].target);
    };
    edges_.erase(std::remove_if(edges_.begin(), edges_.end(), isInner), edges_.end());
  }

  /** Twice the area of each face is the sum over its Delaunay edges; shared ones cancel. */
  void sumAreas() {
    area_.assign(voronoi_.vertices.size(), 0.0);
    if (voronoi_.sites.empty()) return;
    const Point origin = voronoi_.sites.front();
    for (const VoronoiEdge& edge : voronoi_.edges) {
      const double area =
          cross(voronoi_.sites[edge.right] - origin, voronoi_.sites[edge.left] - origin) / 2;
      area_[groups_.find(edge.source)] += area;
      if (!edge.isInfinite()) area_[groups_.find(edge.target)] -= area;
    }
  }

  /** 1 for a square, the ratio of its sides for a rectangle, large for a corridor. */
  double elongation(std::uint32_t region) const {
    const double side = 2 * radius_[region];
    return area_[region] / (side * side);
  }

  std::map<std::uint32_t, Neighbours> neighbours() {
    keepPassages();
    std::map<std::uint32_t, Neighbours> all;
    for (const std::uint32_t e : edges_) {
      const VoronoiEdge& edge = voronoi_.edges[e];
      const auto a = groups_.find(edge.source), b = groups_.find(edge.target);
      for (Passage* passage : {&all[a][b], &all[b][a]}) {
        ++passage->count;
        if (edge.minClearance <= passage->width) continue;
        passage->width = edge.minClearance;
        passage->at =
            midpoint(voronoi_.vertices[edge.source].at, voronoi_.vertices[edge.target].at);
      }
    }
    return all;
  }

  /** The one region that this is a niche of: wide beside it, not behind a door, while all others
   *  are niches of this one. None where there is no such, or more than one. */
  std::uint32_t ownerOf(std::uint32_t region, const Neighbours& around) const {
    std::uint32_t owner = Regions::kNone;
    for (const auto& [other, passage] : around) {
      const bool isOpen = !isDoor(passage.width, region, other);
      if (isOpen && isNarrowBeside(other, region)) continue;
      if (owner != Regions::kNone || !isOpen || !isNarrowBeside(region, other))
        return Regions::kNone;
      owner = other;
    }
    return owner;
  }

  /** A region, the one that it may be a niche of, and how far it reaches into the wall. */
  struct Niche {
    std::uint32_t region, owner;
    Passage opening;
    double depth = 0;
  };

  std::vector<Niche> niches() {
    std::vector<Niche> found;
    std::vector<std::uint32_t> indexOf(voronoi_.vertices.size(), Regions::kNone);
    for (const auto& [region, around] : neighbours()) {
      const std::uint32_t owner = ownerOf(region, around);
      if (owner == Regions::kNone) continue;
      indexOf[region] = std::uint32_t(found.size());
      found.push_back({region, owner, around.at(owner), 0});
    }
    if (found.empty()) return found;
    for (std::uint32_t v = 0; v < voronoi_.vertices.size(); ++v) {
      const std::uint32_t index = isInside_[v] ? indexOf[groups_.find(v)] : Regions::kNone;
      if (index == Regions::kNone) continue;
      Niche& niche = found[index];
      niche.depth = std::max(niche.depth, distance(voronoi_.vertices[v].at, niche.opening.at));
    }
    return found;
  }

  /** Joins all niches with their owners at once; returns whether there were any. */
  bool absorbNiches() {
    bool isAny = false;
    for (const Niche& niche : niches()) {
      if (niche.depth > options_.maxNicheDepth * 2 * niche.opening.width) continue;
      join(groups_.find(niche.region), groups_.find(niche.owner));
      isAny = true;
    }
    return isAny;
  }

  bool isCorridor(std::uint32_t region, const Neighbours& around) const {
    // A door frame is wider than it is deep; the disc in a room leaves at most its corners over.
    constexpr double frameElongation = 0.5;
    if (2 * radius_[region] < options_.minRoomWidth * (1 - kSame)) return true;
    if (elongation(region) < frameElongation) return true;
    int exits = 0;
    for (const auto& [other, passage] : around) exits += passage.count;
    return exits > 1 && elongation(region) > options_.maxElongation &&
           2 * radius_[region] <= options_.maxCorridorWidth;
  }

  /** What is no corridor. */
  Regions rooms() {
    const auto around = neighbours();
    std::vector<std::uint8_t> isRoom(voronoi_.vertices.size());
    for (std::uint32_t v = 0; v < isRoom.size(); ++v) {
      if (!isInside_[v] || groups_.find(v) != v) continue;
      const auto it = around.find(v);
      isRoom[v] = !isCorridor(v, it == around.end() ? Neighbours() : it->second);
    }
    const auto isMember = [&](std::uint32_t v) { return isInside_[v] && isRoom[groups_.find(v)]; };
    return numbered(groups_, isMember, voronoi_.vertices.size(), 0);
  }

  const VoronoiGraph& voronoi_;
  const InsideFlags& isInside_;
  const SplitAtDoorsOptions& options_;
  std::vector<std::uint32_t> edges_;
  UnionFind groups_;
  std::vector<double> radius_;  // of the largest disc
  std::vector<double> area_;
};

}  // namespace

void describe(SplitAtDoorsOptions& options, FieldTable& table) {
  const char* section = "split_at_doors";
  table.number(
      section, "max_ratio", options.maxRatio, "", 0, 1,
      "A passage is a door where it is narrower than this share of the narrower of its two "
      "sides.");
  table.number(section, "max_width", options.maxWidth, "m", 0, 100, "A wider passage is no door.");
  table.number(
      section, "niche_ratio", options.nicheRatio, "", 0, 1,
      "A region narrower than this share of the one that it opens into is a niche of that.");
  table.number(section, "max_niche_depth", options.maxNicheDepth, "", 0, 1e6,
               "A niche deeper than this many widths of its opening is a corridor.");
  table.number(section, "min_side_width", options.minSideWidth, "m", 0, 100,
               "A door has room for a disc of this diameter on each of its sides.");
  table.number(section, "min_room_width", options.minRoomWidth, "m", 0, 100,
               "Where no disc of this diameter fits in is no room.");
  table.number(section, "max_elongation", options.maxElongation, "", 1, 1e6,
               "A region whose area is more than this many squares round its largest disc is a "
               "corridor.");
  table.number(section, "max_corridor_width", options.maxCorridorWidth, "m", 0, 1000,
               "A region wider than this is a room, however long it is.");
}

Regions splitAtDoors(const VoronoiGraph& voronoi, const InsideFlags& isInside, double minClearance,
                     const SplitAtDoorsOptions& options) {
  return Splitter(voronoi, isInside, minClearance, options).run();
}

}  // namespace roomgraph
