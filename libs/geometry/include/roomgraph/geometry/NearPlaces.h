#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Finds those of many places that lie near a point, without looking at all of them. */
class NearPlaces {
 public:
  /** `reach` is the largest distance that will be asked for [m], above 0. O(n log n). */
  NearPlaces(const std::vector<Point>& places, double reach);

  /** Calls `visit` with the index of each place up to `reach` away from `at`, and of some that are
   *  farther: of all in the 3 x 3 squares of side `reach` round it, by column, then by row, then by
   *  index. O(log n + places visited). */
  template <class Visit>
  void forEachNear(Point at, const Visit& visit) const {
    const Point square = squareOf(at);
    for (const double column : {square.x - 1, square.x, square.x + 1}) {
      const Entry first{{column, square.y - 1}, 0};
      for (auto it = std::lower_bound(entries_.begin(), entries_.end(), first);
           it != entries_.end() && it->square.x == column && it->square.y <= square.y + 1; ++it)
        visit(it->index);
    }
  }

 private:
  struct Entry {
    Point square;  ///< its number along x and y
    std::uint32_t index = 0;

    friend bool operator<(const Entry& l, const Entry& r) {
      return l.square != r.square ? l.square < r.square : l.index < r.index;
    }
  };
  [[nodiscard]] Point squareOf(Point p) const {
    return {std::floor(p.x / reach_), std::floor(p.y / reach_)};
  }

  double reach_;
  std::vector<Entry> entries_;  // sorted
};

}  // namespace roomgraph
