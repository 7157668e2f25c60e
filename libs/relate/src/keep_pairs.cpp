#include "keep_pairs.h"

#include <utility>

#include "pair_bytes.h"
#include "related_sources.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/version.h"

namespace roomgraph {

RelatePair keepPairs(RelatePair relate, const std::vector<Run>& runs, const std::string& how,
                     const KeptPairs& kept) {
  if (!kept.read) return relate;
  std::vector<std::string> prints;
  for (const Run& run : runs) prints.push_back(fingerprint(run.map));
  const std::string program = std::string(version()) + ' ' + kRelatedSources + ' ' + how;
  return [relate = std::move(relate), prints = std::move(prints), program, &runs, &kept](
             const PairOver& pair, FullMaps& maps) {
    std::string all = program + ' ' + prints[pair.a] + ' ' + prints[pair.b];
    if (pair.hub != pair.a && pair.hub != pair.b) all += ' ' + prints[pair.hub];
    const std::string name =
        sha256Of({reinterpret_cast<const std::uint8_t*>(all.data()), all.size()});
    if (const auto bytes = kept.read(name))
      if (auto known = pairOfBytes(*bytes, runs[pair.a].map, runs[pair.b].map))
        return std::move(*known);
    MapPair found = relate(pair, maps);
    kept.write(name, pairBytes(found));
    return found;
  };
}

}  // namespace roomgraph
