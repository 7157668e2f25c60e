#include "roomgraph/rooms/RoomIndex.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

constexpr double kTouches = 1e-7;  // of the length of a segment: how far off it a place on it is

/** Whether a place lies on a segment, but for rounding, which must not decide. */
bool isOn(Point p, Point a, Point b) {
  const Point along = b - a, off = p - a;
  const double squared = dot(along, along), place = dot(along, off);
  return std::abs(cross(along, off)) <= kTouches * squared && place >= -kTouches * squared &&
         place <= (1 + kTouches) * squared;
}

}  // namespace

RoomIndex::Bucket RoomIndex::Buckets::at(Point p) const {
  return {std::int64_t(std::floor(p.x / size)), std::int64_t(std::floor(p.y / size))};
}

template <class Visit>
void RoomIndex::Buckets::forEach(Point p, Point q, const Visit& visit) const {
  const Bucket low = at({std::min(p.x, q.x), std::min(p.y, q.y)});
  const Bucket high = at({std::max(p.x, q.x), std::max(p.y, q.y)});
  for (auto x = low.first; x <= high.first; ++x)
    for (auto y = low.second; y <= high.second; ++y) visit(Bucket{x, y});
}

void RoomIndex::Buckets::add(std::uint32_t thing, Point p, Point q) {
  forEach(p, q, [&](Bucket bucket) { lists[bucket].push_back(thing); });
}

std::size_t RoomIndex::Rows::rowOf(double y) const {
  if (rowHeight <= 0) return 0;
  const auto row = std::size_t(std::max(0.0, (y - box.low.y) / rowHeight));
  return std::min(row, first.size() - 2);
}

RoomIndex::Rows RoomIndex::makeRows(const Polygon& polygon) {
  Rows rows;
  rows.box = boundingBox(polygon.outer);
  // About as many rows as a square has points on one side.
  const auto count = std::max<std::size_t>(1, polygon.outer.size() / 4);
  rows.rowHeight = (rows.box.high.y - rows.box.low.y) / double(count);
  rows.first.assign(count + 1, 0);
  const auto forEachTouch = [&](const auto& visit) {
    forEachEdge(polygon, [&](Point a, Point b) {
      const double reach = kTouches * distance(a, b);
      const auto last = rows.rowOf(std::max(a.y, b.y) + reach);
      for (auto row = rows.rowOf(std::min(a.y, b.y) - reach); row <= last; ++row) visit(row, a, b);
    });
  };
  forEachTouch([&](std::size_t row, Point, Point) { ++rows.first[row + 1]; });
  std::partial_sum(rows.first.begin(), rows.first.end(), rows.first.begin());
  rows.edges.resize(rows.first.back());
  std::vector<std::uint32_t> next = rows.first;
  forEachTouch([&](std::size_t row, Point a, Point b) { rows.edges[next[row]++] = {a, b}; });
  return rows;
}

bool RoomIndex::isInside(const Rows& rows, Point p) {
  if (!rows.box.contains(p)) return false;
  bool isOdd = false;
  const std::size_t row = rows.rowOf(p.y);
  for (auto i = rows.first[row]; i < rows.first[row + 1]; ++i) {
    const auto& [a, b] = rows.edges[i];
    if (isOn(p, a, b)) return false;
    if (rayCrosses(p, a, b)) isOdd = !isOdd;
  }
  return isOdd;
}

RoomIndex::RoomIndex(const Rooms& rooms) { addRooms(rooms); }

RoomIndex::RoomIndex(const Rooms& rooms, double clearance) : RoomIndex(rooms) {
  // A little less than twice, against rounding; far more than any edge along a wall.
  addOpenings(rooms, 2 * clearance * (1 - 1e-9));
}

void RoomIndex::addRooms(const Rooms& rooms) {
  double sum = 0;
  for (const Room& room : rooms) {
    rooms_.push_back(makeRows(room.polygon));
    const Point diagonal = rooms_.back().box.high - rooms_.back().box.low;
    sum += std::max(diagonal.x, diagonal.y);
  }
  if (sum > 0) roomBuckets_.size = sum / double(rooms_.size());
  for (std::uint32_t i = 0; i < rooms_.size(); ++i)
    roomBuckets_.add(i, rooms_[i].box.low, rooms_[i].box.high);
}

void RoomIndex::addOpenings(const Rooms& rooms, double shortest) {
  double sum = 0;
  for (const Room& room : rooms)
    forEachEdge(room.polygon, [&](Point a, Point b) {
      if (distance(a, b) < shortest) return;
      openings_.push_back({a, b});
      sum += distance(a, b);
    });
  if (sum > 0) openingBuckets_.size = sum / double(openings_.size());
  for (std::uint32_t i = 0; i < openings_.size(); ++i)
    openingBuckets_.add(i, openings_[i].first, openings_[i].second);
}

std::vector<RoomIndex::Opening> RoomIndex::openingsNear(Point p, Point q) const {
  std::vector<std::uint32_t> found;
  if (openings_.empty()) return {};
  openingBuckets_.forEach(p, q, [&](Bucket bucket) {
    const auto it = openingBuckets_.lists.find(bucket);
    if (it == openingBuckets_.lists.end()) return;
    found.insert(found.end(), it->second.begin(), it->second.end());
  });
  sortUnique(found);
  std::vector<Opening> openings;
  for (const auto i : found) openings.push_back(openings_[i]);
  return openings;
}

RoomId RoomIndex::roomAt(Point p) const {
  const auto it = roomBuckets_.lists.find(roomBuckets_.at(p));
  if (it == roomBuckets_.lists.end()) return RoomId::none();
  for (const std::uint32_t i : it->second)
    if (isInside(rooms_[i], p)) return RoomId(i);
  return RoomId::none();
}

}  // namespace roomgraph
