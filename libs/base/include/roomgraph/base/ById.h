#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "roomgraph/base/Ids.h"

namespace roomgraph {

/** Successive ids, from `first` to before `end`; by default none. */
template <class IdType>
class IdRange {
 public:
  class Iterator {
   public:
    explicit Iterator(std::size_t index) : index_(index) {}
    IdType operator*() const { return IdType(index_); }
    Iterator& operator++() { return ++index_, *this; }
    friend bool operator!=(Iterator a, Iterator b) { return a.index_ != b.index_; }

   private:
    std::size_t index_;
  };

  IdRange() = default;
  IdRange(std::size_t first, std::size_t end) : first_(first), end_(end) {}

  [[nodiscard]] Iterator begin() const { return Iterator(first_); }
  [[nodiscard]] Iterator end() const { return Iterator(end_); }
  [[nodiscard]] std::size_t size() const { return end_ - first_; }
  [[nodiscard]] bool isEmpty() const { return first_ == end_; }
  [[nodiscard]] bool has(IdType id) const { return first_ <= id.index() && id.index() < end_; }
  /** The id at a place in the range, and the place of an id in it. */
  [[nodiscard]] IdType operator[](std::size_t place) const { return IdType(first_ + place); }
  [[nodiscard]] std::size_t placeOf(IdType id) const { return id.index() - first_; }
  /** Must not be called on an empty range. */
  [[nodiscard]] IdType front() const { return IdType(first_); }
  [[nodiscard]] IdType back() const { return IdType(end_ - 1); }

 private:
  std::size_t first_ = 0, end_ = 0;
};

/** Things that are named by ids of their own: a vector that takes no other index. */
template <class IdType, class Thing>
class ById {
 public:
  ById() = default;
  explicit ById(std::size_t size, const Thing& thing = {}) : things_(size, thing) {}
  explicit ById(std::vector<Thing> things) : things_(std::move(things)) {}

  decltype(auto) operator[](IdType id) { return things_[id.index()]; }
  decltype(auto) operator[](IdType id) const { return things_[id.index()]; }
  IdType add(Thing thing) {
    things_.push_back(std::move(thing));
    return IdType(things_.size() - 1);
  }
  [[nodiscard]] std::size_t size() const { return things_.size(); }
  [[nodiscard]] IdRange<IdType> ids() const { return {0, things_.size()}; }

  auto begin() { return things_.begin(); }
  auto end() { return things_.end(); }
  [[nodiscard]] auto begin() const { return things_.begin(); }
  [[nodiscard]] auto end() const { return things_.end(); }

 private:
  std::vector<Thing> things_;
};

}  // namespace roomgraph
