#include "roomgraph/evaluation/stability.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** The finaliser of splitmix64: near numbers come out far apart. */
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

/** Repeat 0 is the base map. */
std::uint64_t seedOf(std::uint64_t seed, int distance, double percent, int repeat) {
  std::uint64_t percentBits = 0;
  static_assert(sizeof percentBits == sizeof percent, "a double of 64 bits");
  std::memcpy(&percentBits, &percent, sizeof percent);
  return mixed(mixed(mixed(mixed(seed) ^ std::uint64_t(distance)) ^ percentBits) ^
               std::uint64_t(repeat));
}

template <class Number>
void checkList(const std::vector<Number>& list, double low, double high, const char* name,
               const char* unit) {
  const std::string range = ": use numbers from " + std::to_string(int(low)) + " to " +
                            std::to_string(int(high)) + unit + ", each once";
  if (list.empty()) throw UsageError(std::string("no noise ") + name + range);
  for (const Number value : list)
    if (!(value >= low && value <= high))
      throw UsageError(std::string("noise ") + name + ": " + std::to_string(value) + range);
  if (std::set<Number>(list.begin(), list.end()).size() != list.size())
    throw UsageError(std::string("noise ") + name + ": a number is listed twice" + range);
}

void check(const StabilityOptions& options) {
  checkList(options.distances, 1, 1000, "distances", " cells");
  checkList(options.percents, 0, 100, "percents", " percent");
  constexpr int kMostRepeats = 10000;
  if (options.repeats < 1 || options.repeats > kMostRepeats)
    throw UsageError("repeats: " + std::to_string(options.repeats) + ": use 1 to " +
                     std::to_string(kMostRepeats));
}

/** The thresholded map as one to extract from: three greys, and options that tell them apart. */
GreyMap greyMap(const Grid& grid) {
  GreyMap map;
  map.frame = grid.frame;
  map.grey.reserve(grid.cells.size());
  for (const State state : grid.cells)
    map.grey.push_back(state == State::occupied ? 0 : state == State::free ? 255 : 128);
  return map;
}

Stages extractNoisy(const Grid& grid, const WallNoise& noise, ExtractOptions extractOptions) {
  extractOptions.binarize.blackThreshold = 0;
  extractOptions.binarize.occupiedAbove = 0.75;
  extractOptions.binarize.freeBelow = 0.25;
  return extract(greyMap(addWallNoise(grid, noise)), extractOptions);
}

GraphDistance graphDistance(const TopologyGraph& base, const TopologyGraph& other,
                            double matchWithin) {
  return {nearestVertices(base, other),
          vertexAgreement(matchVertices(base, other, matchWithin), base.vertices().size(),
                          other.vertices().size())};
}

/** Whether a value that is missing makes the mean meaningless. */
enum class Missing { spoils, isLeftOut };

template <class Things, class Get>
std::optional<double> meanOf(const Things& things, Missing missing, Get get) {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& thing : things) {
    const std::optional<double> value = get(thing);
    if (!value && missing == Missing::spoils) return std::nullopt;
    if (!value) continue;
    sum += *value;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / double(count);
}

template <class Things, class Get>
GraphDistance meanDistance(const Things& things, Get get) {
  const auto mean = [&](Missing missing, auto part) {
    return meanOf(things, missing, [&](const auto& thing) { return part(get(thing)); });
  };
  using D = const GraphDistance&;
  GraphDistance result;
  result.nearest = mean(Missing::spoils, [](D d) { return d.nearest; });
  VertexAgreement& agreement = result.agreement;
  agreement.median = mean(Missing::isLeftOut, [](D d) { return d.agreement.median; });
  agreement.percentile90 = mean(Missing::isLeftOut, [](D d) { return d.agreement.percentile90; });
  agreement.unmatchedBase = mean(Missing::spoils, [](D d) { return d.agreement.unmatchedBase; });
  agreement.unmatchedOther = mean(Missing::spoils, [](D d) { return d.agreement.unmatchedOther; });
  return result;
}

/** What rows share with their mean. `things` have the members of RunMeasures and of StabilityRow.
 */
template <class Things>
StabilityRow meanRow(const Things& things) {
  StabilityRow row;
  row.room = meanDistance(things, [](const auto& t) -> const GraphDistance& { return t.room; });
  row.noRoom = meanDistance(things, [](const auto& t) -> const GraphDistance& { return t.noRoom; });
  row.roomsFound = meanOf(things, Missing::spoils, [](const auto& t) { return t.roomsFound; });
  return row;
}

StabilityRow rowOf(const StabilityRun& run, const std::vector<RunMeasures>& repeats,
                   std::size_t baseRooms) {
  StabilityRow row = meanRow(repeats);
  row.distance = run.noise.maxDistance;
  row.percent = run.noise.percent;
  if (row.room.nearest && row.noRoom.nearest && *row.noRoom.nearest > 0)
    row.ratio = *row.room.nearest / *row.noRoom.nearest;
  for (const RunMeasures& m : repeats)
    row.roomsChange += std::abs(m.rooms - double(baseRooms)) / double(repeats.size());
  return row;
}

StabilityRow meanOfRows(const std::vector<StabilityRow>& rows) {
  StabilityRow mean = meanRow(rows);
  mean.ratio = meanOf(rows, Missing::spoils, [](const StabilityRow& row) { return row.ratio; });
  for (const StabilityRow& row : rows) mean.roomsChange += row.roomsChange / double(rows.size());
  return mean;
}

}  // namespace

std::vector<StabilityRun> stabilityRuns(const StabilityOptions& options) {
  check(options);
  std::vector<int> distances = options.distances;
  std::vector<double> percents = options.percents;
  std::sort(distances.begin(), distances.end());
  std::sort(percents.begin(), percents.end());
  std::vector<StabilityRun> runs;
  for (const int distance : distances)
    for (const double percent : percents)
      for (int repeat = 1; repeat <= options.repeats; ++repeat)
        runs.push_back(
            {{distance, percent, seedOf(options.seed, distance, percent, repeat)}, repeat});
  return runs;
}

StabilityBase stabilityBase(const GreyMap& map, const ExtractOptions& extract,
                            const StabilityOptions& options) {
  StabilityBase base;
  base.grid = binarize(map, extract.binarize);
  base.extract = extract;
  base.matchWithin = options.matchWithin;
  const WallNoise noise{options.baseDistance, options.basePercent,
                        seedOf(options.seed, options.baseDistance, options.basePercent, 0)};
  Stages stages = extractNoisy(base.grid, noise, extract);
  base.noRoom = std::move(stages.kept);
  base.room = std::move(stages.result);
  return base;
}

RunMeasures measureRun(const StabilityBase& base, const StabilityRun& run) {
  const Stages noisy = extractNoisy(base.grid, run.noise, base.extract);
  RunMeasures measures;
  measures.room = graphDistance(base.room.graph, noisy.result.graph, base.matchWithin);
  measures.noRoom = graphDistance(base.noRoom, noisy.kept, base.matchWithin);
  const auto found = matchRooms(base.room.rooms, noisy.result.rooms, base.grid.frame);
  if (!base.room.rooms.empty())
    measures.roomsFound = double(found.size()) / double(base.room.rooms.size());
  measures.rooms = int(noisy.result.rooms.size());
  return measures;
}

Stability summarizeStability(const GreyMap& map, const StabilityBase& base,
                             const StabilityOptions& options, std::vector<RunMeasures> measures) {
  Stability result;
  result.options = options;
  result.extract = base.extract;
  result.source = map.source;
  result.frame = map.frame;
  result.baseVerticesRoom = base.room.graph.vertices().size();
  result.baseVerticesNoRoom = base.noRoom.vertices().size();
  result.baseRooms = base.room.rooms.size();
  result.runs = stabilityRuns(options);
  result.measures = std::move(measures);
  const auto repeats = std::size_t(options.repeats);
  for (std::size_t first = 0; first < result.runs.size(); first += repeats) {
    const auto begin = result.measures.begin() + std::ptrdiff_t(first);
    result.rows.push_back(
        rowOf(result.runs[first], {begin, begin + std::ptrdiff_t(repeats)}, result.baseRooms));
  }
  result.mean = meanOfRows(result.rows);
  return result;
}

}  // namespace roomgraph
