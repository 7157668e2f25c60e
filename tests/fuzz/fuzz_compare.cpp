// Two to four tiny maps: compares them, writes all results and reads them back; then once more with
// pairs out of a cache that somebody has changed and given the right checksum.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <vector>

#include "odd_maps.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/compare/compare_runs.h"
#include "roomgraph/compare/prepare_run.h"
#include "roomgraph/report/comparison_csv.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/site_json.h"

namespace {

using namespace roomgraph;
using test::ByteSource;

/** The first map moved, mirrored, or with some cells changed; or another one. */
GreyMap nextMap(ByteSource& bytes, GreyMap map) {
  const double shifts[] = {0, 0.01, 0.5, 3, 1e6};
  switch (bytes.below(5)) {
    case 0:
      return test::oddMap(bytes);
    case 1:
      for (int y = 0; y < map.frame.height; ++y)
        for (int x = 0; 2 * x < map.frame.width; ++x)
          std::swap(map.grey[map.frame.index({x, y})],
                    map.grey[map.frame.index({map.frame.width - 1 - x, y})]);
      return map;
    case 2:
      for (unsigned n = bytes.below(20); n > 0 && !map.grey.empty(); --n)
        map.grey[bytes.below(unsigned(map.grey.size()))] = bytes.byte();
      return map;
    default:
      map.frame.origin.x = std::min(kFarthestOrigin, map.frame.origin.x + bytes.oneOf(shifts));
      map.frame.origin.y = std::max(-kFarthestOrigin, map.frame.origin.y - bytes.oneOf(shifts));
      return map;
  }
}

std::vector<Run> oddRuns(ByteSource& bytes) {
  const GreyMap first = test::oddMap(bytes);
  std::vector<Run> runs;
  for (unsigned left = 2 + bytes.below(3); left > 0; --left) {
    const std::string name(1, char('a' + left));
    try {
      runs.push_back(
          prepareRun(name, runs.empty() ? first : nextMap(bytes, first), {}, ExtractOptions()));
    } catch (const DataError&) {  // no wall
    }
  }
  return runs;
}

/** With some of its numbers changed, behind the right checksum. */
std::string changedPair(ByteSource& bytes, std::string pair) {
  const double odd[] = {0, -1, 1, 1e6, 4e9, 1e300, -1e-300, 0.5};
  const std::size_t checksum = pair.find('\n') + 1, body = checksum + 64;
  const std::size_t numbers = (pair.size() - body) / sizeof(double);
  for (unsigned n = 1 + bytes.below(3); n > 0 && numbers > 0; --n) {
    const double value = bytes.oneOf(odd);
    std::memcpy(&pair[body + sizeof value * bytes.below(unsigned(numbers))], &value, sizeof value);
  }
  const auto* raw = reinterpret_cast<const std::uint8_t*>(pair.data());
  return pair.replace(checksum, 64, sha256Of({raw + body, pair.size() - body}));
}

void check(const Comparison& comparison) {
  const std::string json = comparisonJson(comparison);
  const Comparison saved = parseComparisonJson(json, "comparison.json");
  if (comparisonJson(saved) != json) std::abort();
  comparisonRunsCsv(saved), comparisonRoomsCsv(saved), siteGeojson(saved);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteSource bytes(data, size);
  const std::vector<Run> runs = oddRuns(bytes);
  if (runs.empty()) return 0;
  std::map<std::string, std::string> kept;
  CompareRunsOptions options;
  options.areAligned = bytes.below(4) == 3;
  options.kept.write = [&](const std::string& name, const std::string& pair) { kept[name] = pair; };
  options.kept.read = [](const std::string&) { return std::nullopt; };
  check(compareRuns(runs, options));

  options.kept.read = [&](const std::string& name) -> std::optional<std::string> {
    const auto found = kept.find(name);
    if (found == kept.end()) return std::nullopt;
    return changedPair(bytes, found->second);
  };
  options.kept.write = [](const std::string&, const std::string&) {};
  check(compareRuns(runs, options));
  return 0;
}
