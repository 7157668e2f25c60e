#pragma once
#include <algorithm>
#include <iterator>

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

}  // namespace roomgraph
