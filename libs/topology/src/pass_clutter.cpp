#include "roomgraph/topology/pass_clutter.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "roomgraph/base/UnionFind.h"

namespace roomgraph {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
/** Widths and lengths that differ by less than this share are equal: rounding must not decide. */
constexpr double kSame = 1e-9;

/** Where one gets through between two blocks: kept edges that follow each other, without a
 *  branch. */
struct Passage {
  std::uint32_t left, right;  ///< an obstacle of either block
  std::uint32_t number;       ///< of all passages
  double width;               ///< half of it [m]
  double length;              ///< of all edges [m]
};

/** Whether nobody misses `a` as much as `b`: it is narrower, or as narrow and longer. */
bool isWorse(const Passage& a, const Passage& b) {
  if (a.width < b.width * (1 - kSame)) return true;
  return a.width < b.width * (1 + kSame) && a.length > b.length * (1 + kSame);
}

/** Works on blocks: obstacles with no kept edge between them. They are the faces of the kept
 *  edges; one that is clutter has a ring of passages round it. */
class ClutterPasser {
 public:
  ClutterPasser(const VoronoiGraph& voronoi, const EdgeIndices& kept,
                const std::vector<std::uint8_t>& isClutter)
      : voronoi_(voronoi),
        kept_(kept),
        isKept_(voronoi.edges.size()),
        blocks_(voronoi.obstacles.size()),
        stays_(voronoi.obstacles.size()) {
    for (const std::uint32_t e : kept) isKept_[e] = 1;
    for (std::size_t e = 0; e < isKept_.size(); ++e)
      if (!isKept_[e]) blocks_.join(voronoi.edges[e].left, voronoi.edges[e].right);
    for (std::uint32_t i = 0; i < stays_.size(); ++i)
      if (!isClutter[i]) stays_[blocks_.find(i)] = 1;
  }

  EdgeIndices run(const std::function<bool(Point)>& isInRoom) {
    const EdgeIndices edges = besideClutter(isInRoom);
    const std::vector<std::uint32_t> passageOf = findPassages(edges);
    isClosed_.assign(passages_.size(), 0);
    while (closeWorst()) {
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (isClosed_[passageOf[i]]) isKept_[edges[i]] = 0;
    EdgeIndices left;
    for (const std::uint32_t e : kept_)
      if (isKept_[e]) left.push_back(e);
    return left;
  }

 private:
  bool isPassed(std::uint32_t obstacle) { return !stays_[blocks_.find(obstacle)]; }
  bool isBesideClutter(const VoronoiEdge& edge) {
    return blocks_.find(edge.left) != blocks_.find(edge.right) &&
           (isPassed(edge.left) || isPassed(edge.right));
  }

  /** The edges round all clutter but that with one in a room. */
  EdgeIndices besideClutter(const std::function<bool(Point)>& isInRoom) {
    EdgeIndices edges;
    for (const std::uint32_t e : kept_) {
      const VoronoiEdge& edge = voronoi_.edges[e];
      if (!isBesideClutter(edge)) continue;
      edges.push_back(e);
      if (isInRoom(voronoi_.vertices[edge.source].at) ||
          isInRoom(voronoi_.vertices[edge.target].at))
        stays_[blocks_.find(edge.left)] = stays_[blocks_.find(edge.right)] = 1;
    }
    const auto stays = [&](std::uint32_t e) { return !isBesideClutter(voronoi_.edges[e]); };
    edges.erase(std::remove_if(edges.begin(), edges.end(), stays), edges.end());
    return edges;
  }

  /** The passages, and to which of them each of the ascending edges belongs. */
  std::vector<std::uint32_t> findPassages(const EdgeIndices& edges) {
    std::vector<std::uint32_t> degree(voronoi_.vertices.size()), first(degree.size(), kNone);
    for (const std::uint32_t e : kept_)
      for (const std::uint32_t v : endsOf(e)) ++degree[v];
    UnionFind groups(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      for (const std::uint32_t v : endsOf(edges[i])) {
        if (first[v] == kNone) first[v] = i;
        if (degree[v] == 2) groups.join(first[v], i);
      }
    std::vector<std::uint32_t> passageOf(edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      const std::uint32_t group = groups.find(i);  // goes by its first edge
      passageOf[i] = group == i ? addPassage(edges[i]) : passageOf[group];
      addTo(passages_[passageOf[i]], edges[i]);
    }
    return passageOf;
  }

  std::array<std::uint32_t, 2> endsOf(std::uint32_t e) const {
    return {voronoi_.edges[e].source, voronoi_.edges[e].target};
  }

  std::uint32_t addPassage(std::uint32_t e) {
    const VoronoiEdge& edge = voronoi_.edges[e];
    const auto number = std::uint32_t(passages_.size());
    passages_.push_back({edge.left, edge.right, number, edge.minClearance, 0});
    return number;
  }

  void addTo(Passage& passage, std::uint32_t e) const {
    const auto [source, target] = endsOf(e);
    passage.width = std::min(passage.width, voronoi_.edges[e].minClearance);
    passage.length += distance(voronoi_.vertices[source].at, voronoi_.vertices[target].at);
  }

  /** The worst passage beside a block. */
  struct Worst {
    std::uint32_t passage = kNone;
    bool isTie = false;
  };

  /** Each piece of clutter joins the nearest block round it, all at once, so that no order
   *  matters. Returns whether there was any. */
  bool closeWorst() {
    const auto isInner = [&](const Passage& p) {
      return blocks_.find(p.left) == blocks_.find(p.right);
    };
    passages_.erase(std::remove_if(passages_.begin(), passages_.end(), isInner), passages_.end());
    std::vector<std::uint32_t> gaps;
    for (const auto& [block, worst] : worstPassages()) {
      if (worst.isTie)
        stays_[block] = 1;
      else
        gaps.push_back(worst.passage);
    }
    for (const std::uint32_t gap : gaps) close(passages_[gap]);
    return !gaps.empty();
  }

  std::map<std::uint32_t, Worst> worstPassages() {
    std::map<std::uint32_t, Worst> worst;
    for (std::uint32_t i = 0; i < passages_.size(); ++i)
      for (const std::uint32_t obstacle : {passages_[i].left, passages_[i].right}) {
        if (!isPassed(obstacle)) continue;
        Worst& found = worst[blocks_.find(obstacle)];
        if (found.passage == kNone || isWorse(passages_[i], passages_[found.passage]))
          found = {i, false};
        else if (!isWorse(passages_[found.passage], passages_[i]))
          found.isTie = true;
      }
    return worst;
  }

  void close(const Passage& passage) {
    const std::uint32_t a = blocks_.find(passage.left), b = blocks_.find(passage.right);
    if (!blocks_.join(a, b)) return;  // closed from its other side
    isClosed_[passage.number] = 1;
    stays_[blocks_.find(a)] = stays_[a] || stays_[b];
  }

  const VoronoiGraph& voronoi_;
  const EdgeIndices& kept_;
  std::vector<std::uint8_t> isKept_;  // per edge
  UnionFind blocks_;                  // of obstacles
  std::vector<std::uint8_t> stays_;   // per block: rings round it stay
  std::vector<Passage> passages_;
  std::vector<std::uint8_t> isClosed_;  // per passage, by number
};

}  // namespace

EdgeIndices passClutter(const VoronoiGraph& voronoi, EdgeIndices kept,
                        const std::vector<std::uint8_t>& isClutter,
                        const std::function<bool(Point)>& isInRoom) {
  const auto isSome = [](std::uint8_t flag) { return flag != 0; };
  if (std::none_of(isClutter.begin(), isClutter.end(), isSome)) return kept;
  return ClutterPasser(voronoi, kept, isClutter).run(isInRoom);
}

}  // namespace roomgraph
