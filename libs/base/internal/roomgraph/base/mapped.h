#pragma once
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace roomgraph {

/** What `of`, a function or a member, gives of each of the things, in their order. */
template <class Things, class Of>
auto mapped(const Things& things, const Of& of) {
  std::vector<std::decay_t<decltype(std::invoke(of, *std::begin(things)))>> all;
  all.reserve(std::size(things));
  for (const auto& thing : things) all.push_back(std::invoke(of, thing));
  return all;
}

}  // namespace roomgraph
