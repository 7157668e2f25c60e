#include "roomgraph/archive/lasting_change.h"

#include <cmath>

#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** Some values on end, and how many of them lie off their median. */
struct Level {
  double value = 0;
  std::size_t off = 0, count = 0;
};

Level levelOf(const std::vector<double>& values, std::size_t begin, std::size_t end,
              double tolerance) {
  const auto at = [&](std::size_t i) { return values.begin() + std::ptrdiff_t(i); };
  Level level;
  level.value = median({at(begin), at(end)});
  level.count = end - begin;
  for (auto value = at(begin); value != at(end); ++value)
    if (std::abs(*value - level.value) > tolerance / 2) ++level.off;
  return level;
}

bool isSteady(const Level& level) { return 4 * level.off <= level.count; }

}  // namespace

std::optional<LastingChange> lastingChange(const std::vector<double>& values, double tolerance,
                                           std::size_t least) {
  if (values.size() < 2 * least || least == 0) return {};
  std::size_t fewest = levelOf(values, 0, values.size(), tolerance).off;
  if (fewest < least) return {};
  fewest -= least - 1;
  std::optional<LastingChange> found;
  for (std::size_t first = least; first + least <= values.size(); ++first) {
    const Level before = levelOf(values, 0, first, tolerance);
    const Level after = levelOf(values, first, values.size(), tolerance);
    const bool isChange = std::abs(after.value - before.value) > tolerance;
    if (!isChange || !isSteady(before) || !isSteady(after)) continue;
    if (before.off + after.off >= fewest) continue;
    fewest = before.off + after.off;
    found = LastingChange{first, before.value, after.value};
  }
  return found;
}

std::vector<LastingChange> lastingChanges(const std::vector<double>& values, double tolerance,
                                          std::size_t least) {
  std::vector<LastingChange> changes;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= values.size(); ++end) {
    if (end - begin > 60) begin = end - 60;
    const auto at = [&](std::size_t i) { return values.begin() + std::ptrdiff_t(i); };
    auto found = lastingChange({at(begin), at(end)}, tolerance, least);
    if (!found) continue;
    found->first += begin;
    begin = found->first;
    changes.push_back(*found);
  }
  return changes;
}

}  // namespace roomgraph
