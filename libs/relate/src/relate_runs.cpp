#include "roomgraph/relate/relate_runs.h"

#include <algorithm>
#include <utility>

#include "by_straightness.h"
#include "pair_bytes.h"
#include "roomgraph/files/checked_file.h"

namespace roomgraph {

std::size_t hubOf(const std::vector<Run>& runs) {
  return runs.empty() ? 0 : byStraightness(runs).front();
}

namespace {

/** The pairs of some runs, worked out one by one or taken from where they are kept. */
class Relating {
 public:
  Relating(const std::vector<Run>& runs, bool areAligned, const KeptPairs& kept)
      : runs_(runs), areAligned_(areAligned), kept_(kept), related_(runs.size()) {
    if (!kept.read) return;
    for (const Run& run : runs) prints_.push_back(fingerprint(run.map));
  }

  void search(std::size_t a, std::size_t b) {
    related_(a, b) = keptOr({a, b}, [&] {
      return areAligned_ ? relateAlignedMaps(mapOf(a), mapOf(b)) : relateMaps(mapOf(a), mapOf(b));
    });
  }
  /** To be called when both runs have been related to the hub. */
  void relateOver(std::size_t hub, std::size_t a, std::size_t b) {
    if (areAligned_) return search(a, b);
    related_(a, b) = keptOr({a, b, hub}, [&] {
      return relateMapsOver(between(hub, a), between(hub, b), mapOf(a), mapOf(b));
    });
  }
  MapPairs related() { return std::move(related_); }

 private:
  const MapForAlignment& mapOf(std::size_t run) const { return runs_[run].map; }

  MapPair between(std::size_t hub, std::size_t run) const {
    return hub < run ? related_(hub, run) : swapped(related_(run, hub));
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

  const std::vector<Run>& runs_;
  bool areAligned_;
  const KeptPairs& kept_;
  std::vector<std::string> prints_;
  MapPairs related_;
};

}  // namespace

MapPairs relateRuns(const std::vector<Run>& runs, bool areAligned, const ForEach& forEach,
                    const KeptPairs& kept) {
  const std::size_t hub = hubOf(runs);
  std::vector<std::pair<std::size_t, std::size_t>> withHub, others;
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
