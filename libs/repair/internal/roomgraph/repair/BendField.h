#pragma once
#include <bitset>
#include <optional>
#include <vector>

#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph {

/** Where places of one frame lie in another, as one run tells it: each of its nodes, a key frame or
 *  a patch of walls, carries what lies near it, and those that have seen a place from nearest by
 *  say most. */
class BendField {
 public:
  enum class Way { toSite, toRun };
  /** What lies farther apart is another copy of a place [m]. */
  static constexpr double kSameCopy = 0.5;

  /** Of a run of the site, by its key frames. The site must outlive this. */
  BendField(const SolvedSite& solved, const RealPoses& poses, std::size_t run, Way way);
  /** From one run of the site to another, or to itself, by the walls that were followed: without
   *  scans. */
  BendField(const SolvedSite& solved, std::size_t from, std::size_t to);

  /** A place as it was carried. */
  struct Carried {
    Transform2D pose;
    double spread = 0;     ///< of what the nodes say, as a standard deviation [m]
    double nearest = 0;    ///< how far the nearest node is that has seen it, else any [m]
    double rival = 0;      ///< how far off the word lies that differs most, of nodes near by [m]
    bool isSeen = false;   ///< a node has seen it
    bool isKnown = false;  ///< by others, too: the nodes were found in other runs
  };

  /** Nothing where no node lies within reach. O(nodes near + cells between). */
  std::optional<Carried> operator()(const Transform2D& place) const;

 private:
  static constexpr std::size_t kSectors = 60;
  struct Node {
    Transform2D from, to;  ///< frame <- node, in both
    bool isKnown = true;
    std::bitset<kSectors> looks;  ///< at which bearings it has seen walls
  };
  /** What a node says of a place. */
  struct Word {
    Transform2D pose;
    double distance = 0, weight = 0;
    bool isSeen = false, isKnown = true;
  };

  static std::vector<Node> nodesOf(const SolvedSite& solved, std::size_t from, std::size_t to);
  std::vector<Word> wordsOn(const Transform2D& place) const;
  double rivalOf(Point about, const Transform2D& place, const std::vector<Word>& words) const;
  static std::size_t sectorOf(Point inNode);
  bool isInSight(const Node& node, Point place, Point carried) const;

  std::vector<Node> nodes_;
  std::vector<Node> rivals_;      ///< as the other map tells it; only of walls
  const WallMap* map_ = nullptr;  ///< of the run; null where nodes are no key frames
  Way way_ = Way::toSite;
};

}  // namespace roomgraph
