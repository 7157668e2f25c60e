#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "roomgraph/align/SparseCells.h"

namespace roomgraph {

/** An index or none for each cell of a map, as SparseCells; in half the memory where no index needs
 *  more than 16 bits. */
class SparseIndices {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;  ///< stands for no index

  SparseIndices() = default;
  /** O(cells). */
  explicit SparseIndices(const std::vector<std::uint32_t>& cells)
      : areShort_(std::all_of(cells.begin(), cells.end(),
                              [](std::uint32_t i) { return i == kNone || i < kNoShort; })) {
    if (areShort_)  // the lower half of kNone is kNoShort
      short_ = {std::vector<std::uint16_t>(cells.begin(), cells.end()), kNoShort};
    else
      long_ = {cells, kNone};
  }

  [[nodiscard]] std::size_t size() const { return areShort_ ? short_.size() : long_.size(); }

  [[nodiscard]] std::uint32_t operator[](std::size_t cell) const {
    if (!areShort_) return long_[cell];
    const std::uint16_t index = short_[cell];
    return index == kNoShort ? kNone : index;
  }

 private:
  static constexpr std::uint16_t kNoShort = UINT16_MAX;

  bool areShort_ = true;
  SparseCells<std::uint16_t> short_;
  SparseCells<std::uint32_t> long_;
};

}  // namespace roomgraph
