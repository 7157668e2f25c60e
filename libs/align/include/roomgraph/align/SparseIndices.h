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
  SparseIndices() = default;
  /** O(cells). */
  explicit SparseIndices(const std::vector<std::uint32_t>& cells)
      : areShort_(std::all_of(cells.begin(), cells.end(), [](std::uint32_t i) {
          return i == kNoIndex || i < shortened(kNoIndex);
        })) {
    if (areShort_)
      short_ = {std::vector<std::uint16_t>(cells.begin(), cells.end()), shortened(kNoIndex)};
    else
      long_ = {cells, kNoIndex};
  }

  [[nodiscard]] std::size_t size() const { return areShort_ ? short_.size() : long_.size(); }

  [[nodiscard]] std::uint32_t operator[](std::size_t cell) const {
    if (!areShort_) return long_[cell];
    const std::uint16_t index = short_[cell];
    return index == shortened(kNoIndex) ? kNoIndex : index;
  }

 private:
  [[nodiscard]] static constexpr std::uint16_t shortened(std::uint32_t index) {
    return std::uint16_t(index);
  }

  bool areShort_ = true;
  SparseCells<std::uint16_t> short_;
  SparseCells<std::uint32_t> long_;
};

}  // namespace roomgraph
