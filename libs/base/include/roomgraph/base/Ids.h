#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>

namespace roomgraph {

/** The index of a thing in the vector that owns it, or none.
 *  Ids of different things are different types, so one is never taken for another. */
template <class Thing>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value_(static_cast<std::uint32_t>(index)) {}

  [[nodiscard]] static constexpr Id none() { return {}; }                  ///< stands for nothing
  [[nodiscard]] constexpr bool isNone() const { return value_ == kNone; }  ///< stands for nothing
  constexpr explicit operator bool() const { return !isNone(); }           ///< is there
  /** Must not be called on none. */
  [[nodiscard]] constexpr std::size_t index() const { return value_; }

  friend constexpr bool operator==(Id a, Id b) { return a.value_ == b.value_; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value_ != b.value_; }
  /** None sorts last. */
  friend constexpr bool operator<(Id a, Id b) { return a.value_ < b.value_; }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t value_ = kNone;
};

using VertexId = Id<struct VertexTag>;      ///< a place in TopologyGraph::vertices()
using EdgeId = Id<struct EdgeTag>;          ///< a place in TopologyGraph::edges()
using HalfEdgeId = Id<struct HalfEdgeTag>;  ///< 2e along edge e, 2e + 1 back
using RoomId = Id<struct RoomTag>;          ///< a place in RoomGraph::rooms

// Of the pose graph of a site.
using RunId = Id<struct RunTag>;
using NodeId = Id<struct NodeTag>;
using PoseEdgeId = Id<struct PoseEdgeTag>;
using MatchGroupId = Id<struct MatchGroupTag>;

}  // namespace roomgraph
