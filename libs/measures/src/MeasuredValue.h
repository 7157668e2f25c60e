#pragma once
#include <cstddef>
#include <optional>

namespace roomgraph {

/** Fewer other runs can not outvote one that is wrong. */
constexpr std::size_t kFewestOthers = 2;

/** What a measure comes to; its kind says what it is. */
struct MeasuredValue {
  std::optional<double> value{};  ///< none where nothing supports it
  double support = 0;             ///< how many things were counted
  std::optional<double> low{}, high{};
  bool hasEnoughOthers = true;
  std::optional<double> leastSupport{};  ///< instead of that of its kind, where others were counted
};

}  // namespace roomgraph
