#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {

/** Which runs have the same map, and which are edits of one picture: neither is a further witness.
 *  A copy is its original. An edit is measured by itself, but all edits of one picture are one
 *  voice. */
class DistinctMaps {
 public:
  explicit DistinctMaps(const PairBends& bends) {
    UnionFind voices(bends.things());
    for (std::size_t i = 0; i < bends.things(); ++i) {
      std::size_t first = i;
      for (const std::size_t j : bends.othersOf(i)) {
        const PairBend& pair = bends(i, j);
        if (j < first && pair.areIdentical) first = j;
        if (pair.areIdentical || pair.areEdits) voices.join(i, j);
      }
      first_.push_back(first);
      maps_ += first == i;
    }
    for (std::size_t i = 0; i < bends.things(); ++i) {
      voice_.push_back(voices.find(i));
      voices_ += voice_[i] == i;
    }
  }

  /** The first run that has the same map as this one: itself, if none before it has. */
  std::size_t firstOf(std::size_t run) const { return first_[run]; }

  /** The run that speaks for all edits of its picture, this run among them: their first. */
  std::size_t voiceOf(std::size_t run) const { return voice_[run]; }
  bool isVoice(std::size_t run) const { return voice_[run] == run; }

  std::size_t count() const { return voices_; }  ///< of voices
  bool areCopies() const { return maps_ == 1; }  ///< all of one map

  /** Whether a run is measured against another one: against one run of each picture, and against
   *  those of its own only where there is no other. */
  bool isMeasuredAgainst(std::size_t run, std::size_t other) const {
    if (count() == 1) return run != other;
    return isVoice(other) && voiceOf(run) != other;
  }

 private:
  std::vector<std::size_t> first_, voice_;
  std::size_t maps_ = 0, voices_ = 0;
};

}  // namespace roomgraph
