#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace roomgraph {

/** The numbers from `first` to before `end`. */
[[nodiscard]] inline std::vector<std::size_t> numbersFrom(std::size_t first, std::size_t end) {
  std::vector<std::size_t> numbers(end - first);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/** Sorts things by what `of`, a function or a member, gives of them, the least first. Those of
 *  which it gives the same stay in their order. */
template <class Things, class Of>
void sortBy(Things& things, const Of& of) {
  std::stable_sort(things.begin(), things.end(), [&](const auto& l, const auto& r) {
    return std::invoke(of, l) < std::invoke(of, r);
  });
}

/** The same with the most first. */
template <class Things, class Of>
void sortDownBy(Things& things, const Of& of) {
  std::stable_sort(things.begin(), things.end(), [&](const auto& l, const auto& r) {
    return std::invoke(of, l) > std::invoke(of, r);
  });
}

}  // namespace roomgraph
