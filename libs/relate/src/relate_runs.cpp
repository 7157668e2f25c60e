#include "roomgraph/relate/relate_runs.h"

#include <algorithm>
#include <utility>

#include "by_straightness.h"
#include "pair_bytes.h"
#include "roomgraph/grid/checked_file.h"

namespace roomgraph {

Pairs pairsOf(std::size_t runs) {
  Pairs pairs;
  for (std::size_t a = 0; a < runs; ++a)
    for (std::size_t b = a + 1; b < runs; ++b) pairs.emplace_back(a, b);
  return pairs;
}

std::size_t pairIndex(std::size_t a, std::size_t b, std::size_t runs) {
  return a * runs - a * (a + 1) / 2 + b - a - 1;
}

std::size_t hubOf(const std::vector<PreparedRun>& runs) {
  return runs.empty() ? 0 : byStraightness(runs).front();
}

namespace {

/** The pairs of some runs, worked out one by one or taken from where they are kept. */
class Relating {
 public:
  Relating(const std::vector<PreparedRun>& runs, bool areAligned, const KeptPairs& kept)
      : runs_(runs), areAligned_(areAligned), kept_(kept), related_(pairsOf(runs.size()).size()) {
    if (!kept.read) return;
    for (const PreparedRun& run : runs) prints_.push_back(fingerprint(run.map));
  }

  void search(std::size_t a, std::size_t b) {
    related_[pairIndex(a, b, runs_.size())] = keptOr({a, b}, [&] {
      return areAligned_ ? relateAlignedMaps(mapOf(a), mapOf(b)) : relateMaps(mapOf(a), mapOf(b));
    });
  }
  /** To be called when both runs have been related to the hub. */
  void relateOver(std::size_t hub, std::size_t a, std::size_t b) {
    if (areAligned_) return search(a, b);
    related_[pairIndex(a, b, runs_.size())] = keptOr({a, b, hub}, [&] {
      return relateMapsOver(between(hub, a), between(hub, b), mapOf(a), mapOf(b));
    });
  }
  std::vector<MapPair> related() { return std::move(related_); }

 private:
  const MapForAlignment& mapOf(std::size_t run) const { return runs_[run].map; }

  MapPair between(std::size_t hub, std::size_t run) const {
    return hub < run ? related_[pairIndex(hub, run, runs_.size())]
                     : swapped(related_[pairIndex(run, hub, runs_.size())]);
  }

  MapPair keptOr(const std::vector<std::size_t>& maps, const std::function<MapPair()>& work) const {
    if (!kept_.read) return work();
    std::string all = areAligned_ ? "aligned" : "searched";
    for (const std::size_t map : maps) all += ' ' + prints_[map];
    const std::string name =
        sha256Of({reinterpret_cast<const std::uint8_t*>(all.data()), all.size()});
    if (const auto bytes = kept_.read(name))
      if (std::optional<MapPair> pair = pairOfBytes(*bytes, mapOf(maps[0]), mapOf(maps[1])))
        return std::move(*pair);
    MapPair pair = work();
    kept_.write(name, pairBytes(pair));
    return pair;
  }

  const std::vector<PreparedRun>& runs_;
  bool areAligned_;
  const KeptPairs& kept_;
  std::vector<std::string> prints_;
  std::vector<MapPair> related_;
};

}  // namespace

std::vector<MapPair> relateRuns(const std::vector<PreparedRun>& runs, bool areAligned,
                                const ForEach& forEach, const KeptPairs& kept) {
  const std::size_t hub = hubOf(runs);
  Pairs withHub, others;
  for (const auto& [a, b] : pairsOf(runs.size()))
    (a == hub || b == hub ? withHub : others).emplace_back(a, b);
  Relating relating(runs, areAligned, kept);
  forEach(withHub.size(),
          [&](std::size_t i) { relating.search(withHub[i].first, withHub[i].second); });
  forEach(others.size(),
          [&](std::size_t i) { relating.relateOver(hub, others[i].first, others[i].second); });
  return relating.related();
}

}  // namespace roomgraph
