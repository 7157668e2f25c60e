#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace roomgraph {

/** Stands for no index. */
constexpr std::uint32_t kNoIndex = UINT32_MAX;

/** A value for each cell of a map, row-major, where long stretches have one and the same value:
 *  those take no memory. Reading a cell costs one look-up more than in a vector. */
template <class T>
class SparseCells {
 public:
  SparseCells() = default;
  /** `usual` is the value that takes no memory. O(cells). */
  SparseCells(const std::vector<T>& cells, T usual)
      : size_(cells.size()), values_(kStretch, usual) {
    for (std::size_t first = 0; first < cells.size(); first += kStretch) {
      const auto begin = cells.begin() + std::ptrdiff_t(first);
      const auto end = cells.begin() + std::ptrdiff_t(std::min(first + kStretch, cells.size()));
      const bool isUsual = std::all_of(begin, end, [&](const T& cell) { return cell == usual; });
      places_.push_back(isUsual ? 0 : std::uint32_t(values_.size() / kStretch));
      if (isUsual) continue;
      values_.insert(values_.end(), begin, end);
      values_.resize((places_.back() + 1) * kStretch, usual);
    }
    values_.shrink_to_fit();
  }

  [[nodiscard]] std::size_t size() const { return size_; }  ///< cells of the map

  // Without a branch, since which stretches are usual cannot be foretold.
  T operator[](std::size_t cell) const {
    return values_[std::size_t(places_[cell / kStretch]) * kStretch + cell % kStretch];
  }

 private:
  static constexpr std::size_t kStretch = 16;

  std::size_t size_ = 0;
  std::vector<std::uint32_t> places_;  // of each stretch among those that are kept, the first usual
  std::vector<T> values_;
};

}  // namespace roomgraph
