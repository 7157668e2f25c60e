#pragma once
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "roomgraph/rooms/Room.h"

namespace roomgraph {

/** Finds the room at a place, and the polygon edges that a path can cross. */
class RoomIndex {
 public:
  using Opening = std::pair<Point, Point>;  ///< its two ends [m]

  /** For roomAt() alone: no openings. O(polygon points). */
  explicit RoomIndex(const Rooms& rooms);
  /** A path that keeps `clearance` from all obstacles can only cross polygon edges at least twice
   *  as long, since their ends are obstacles: the openings of the room. O(polygon points). */
  RoomIndex(const Rooms& rooms, double clearance);

  /** The openings whose surroundings the segment p–q touches; each once. */
  [[nodiscard]] std::vector<Opening> openingsNear(Point p, Point q) const;

  /** The room whose polygon holds `p` in its inside; none elsewhere. Rooms do not overlap. About
   *  O(polygon points in the row of p). */
  [[nodiscard]] RoomId roomAt(Point p) const;

 private:
  using Bucket = std::pair<std::int64_t, std::int64_t>;
  struct BucketHash {
    std::size_t operator()(Bucket b) const {
      return std::size_t(b.first) * 0x9E3779B97F4A7C15u ^ std::size_t(b.second);
    }
  };
  /** Which things lie near a place: a lattice of squares, each with the things that touch it. */
  struct Buckets {
    double size = 1;  ///< of a square [m]
    std::unordered_map<Bucket, std::vector<std::uint32_t>, BucketHash> lists;

    [[nodiscard]] Bucket at(Point p) const;
    /** Calls `visit` for every square that the box round p and q touches. */
    template <class Visit>
    void forEach(Point p, Point q, const Visit& visit) const;
    void add(std::uint32_t thing, Point p, Point q);
  };

  /** The polygon edges of one room by the rows of height rowHeight that they touch. */
  struct Rows {
    Box box;
    double rowHeight = 0;
    std::vector<std::uint32_t> first;  ///< of each row in edges, and one more
    std::vector<Opening> edges;

    std::size_t rowOf(double y) const;
  };
  [[nodiscard]] static Rows makeRows(const Polygon& polygon);
  [[nodiscard]] static bool isInside(const Rows& rows, Point p);

  void addRooms(const Rooms& rooms);
  void addOpenings(const Rooms& rooms, double shortest);

  std::vector<Rows> rooms_;
  std::vector<Opening> openings_;
  Buckets roomBuckets_, openingBuckets_;
};

}  // namespace roomgraph
