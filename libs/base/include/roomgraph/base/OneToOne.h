#pragma once
#include <cstddef>
#include <vector>

namespace roomgraph {

/** Pairs things of two kinds so that each is in one pair at most: who comes first is served first.
 *
 *      OneToOne pairing(rooms.size(), others.size());
 *      for (const auto& offer : bestFirst)
 *        if (pairing.take(offer.room, offer.other)) matched.push_back(offer);
 */
class OneToOne {
 public:
  OneToOne(std::size_t firsts, std::size_t seconds) : firsts_(firsts), seconds_(seconds) {}

  /** Takes both, and says so; nothing where one of them is taken already. */
  bool take(std::size_t first, std::size_t second) {
    if (firsts_[first] || seconds_[second]) return false;
    firsts_[first] = seconds_[second] = true;
    return true;
  }

  /** Whether a thing of the first kind is in a pair. */
  [[nodiscard]] bool hasFirst(std::size_t first) const { return firsts_[first]; }

 private:
  std::vector<bool> firsts_, seconds_;
};

}  // namespace roomgraph
