#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <cstddef>
#include <type_traits>

namespace roomgraph::test {

/** A key frame of a simplemap: pointers to its pose and to what was seen there. */
template <class Pose, class Frame>
struct SimplemapEntry {
  Pose pose;
  Frame sf;
};

template <class Map, class = void>
struct HasPairs : std::false_type {};
template <class Map>
struct HasPairs<Map, std::void_t<decltype(std::declval<Map&>().getAsPair(0))>> : std::true_type {};

/** MRPT 2.5 keeps pairs, 2.12 and later key frames. */
template <class Map>
auto entryOf(Map& map, std::size_t i) {
  const auto made = [](const auto& e) {
    return SimplemapEntry<decltype(e.pose), decltype(e.sf)>{e.pose, e.sf};
  };
  if constexpr (HasPairs<Map>::value)
    return made(map.getAsPair(i));
  else
    return made(map.get(i));
}

}  // namespace roomgraph::test
