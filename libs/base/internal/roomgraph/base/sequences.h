#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <vector>

namespace roomgraph {

/** Takes out all elements that fit, as std::erase_if() of C++20. */
template <class List, class Predicate>
void eraseIf(List& list, const Predicate& predicate) {
  list.erase(std::remove_if(list.begin(), list.end(), predicate), list.end());
}

/** Sorts a list, and keeps one of each that are equal. */
template <class List>
void sortUnique(List& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/** Whether a value is in a list. O(n). */
template <class List, class Value>
[[nodiscard]] bool contains(const List& list, const Value& value) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

/** Whether one of the things fits: `fits`, a function or a member, tells. */
template <class Things, class Fits>
[[nodiscard]] bool anyOf(const Things& things, const Fits& fits) {
  return std::any_of(std::begin(things), std::end(things),
                     [&](const auto& thing) { return std::invoke(fits, thing); });
}

/** Whether all of them fit. */
template <class Things, class Fits>
[[nodiscard]] bool allOf(const Things& things, const Fits& fits) {
  return std::all_of(std::begin(things), std::end(things),
                     [&](const auto& thing) { return std::invoke(fits, thing); });
}

/** How many of them fit. */
template <class Things, class Fits>
[[nodiscard]] std::size_t countIf(const Things& things, const Fits& fits) {
  return std::size_t(std::count_if(std::begin(things), std::end(things),
                                   [&](const auto& thing) { return std::invoke(fits, thing); }));
}

/** The first of them that fits; null for none. */
template <class Things, class Fits>
[[nodiscard]] auto findIf(Things& things, const Fits& fits) {
  const auto found = std::find_if(std::begin(things), std::end(things), fits);
  return found == std::end(things) ? nullptr : &*found;
}

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

/** What `of`, a function or a member, gives of each of the things, in their order. */
template <class Things, class Of>
auto mapped(const Things& things, const Of& of) {
  std::vector<std::decay_t<decltype(std::invoke(of, *std::begin(things)))>> all;
  all.reserve(std::size(things));
  for (const auto& thing : things) all.push_back(std::invoke(of, thing));
  return all;
}

}  // namespace roomgraph
