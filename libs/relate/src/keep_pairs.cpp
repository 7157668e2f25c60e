#include "keep_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "related_sources.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/version.h"

namespace roomgraph {
namespace {

constexpr std::string_view kHead = "roomgraph/pair\n";

/** Whether a T can have the value. */
template <typename T>
bool holds(double wide) {
  if constexpr (std::is_floating_point_v<T>)
    return std::abs(wide) <= kFarthestPlace || std::isinf(wide);
  // As doubles, the limits of the larger types are powers of two, which are too large.
  return wide >= double(std::numeric_limits<T>::min()) &&
         wide < std::ldexp(1.0, std::numeric_limits<T>::digits) && wide == std::floor(wide);
}

/** The numbers of a pair one after the other, each as a double, which holds all of them exactly.
 *  What it is shown it writes behind the others or, made of bytes, reads: one list of fields for
 *  both ways. Once all are read, or one cannot be, there are but zeros. */
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(std::string_view bytes) : all_(bytes.size() / sizeof(double)), isRead_(true) {
    std::memcpy(all_.data(), bytes.data(), all_.size() * sizeof(double));
  }

  template <typename... T>
  void show(T&... values) {
    (showOne(values), ...);
  }
  template <typename T>
  std::vector<T>& sized(std::vector<T>& list) {
    std::size_t size = list.size();
    show(size);
    if (isRead_) list.resize(std::min(size, all_.size()));
    return list;
  }
  template <typename T>
  bool isThere(std::optional<T>& value) {
    bool isOne = value.has_value();
    show(isOne);
    if (isRead_ && isOne) value.emplace();
    return isOne;
  }
  bool areAllRead() const { return next_ == all_.size() && areWhole_; }
  std::string bytes() const {
    return {reinterpret_cast<const char*>(all_.data()), all_.size() * sizeof(double)};
  }

 private:
  template <typename T>
  void showOne(T& value) {
    if (!isRead_) return all_.push_back(double(value));
    const double wide = next_ < all_.size() ? all_[next_] : 0;
    ++next_;
    areWhole_ = areWhole_ && holds<T>(wide);
    value = areWhole_ ? T(wide) : T();
  }

  std::vector<double> all_;
  std::size_t next_ = 0;
  bool isRead_ = false, areWhole_ = true;
};

void show(Numbers& numbers, Transform2D& pose) { numbers.show(pose.x, pose.y, pose.phi); }

void show(Numbers& numbers, AlignmentCandidate& c) {
  show(numbers, c.pose);
  AlignmentEvidence& e = c.evidence;
  numbers.show(e.close, e.loose, e.slightly, e.contradicted, e.known, e.all, e.weakest, e.overlap,
               e.common, e.freeOnWall, c.score);
}

void show(Numbers& numbers, Alignment& a) {
  show(numbers, a.pose);
  numbers.show(a.confidence, a.siteConfidence, a.overlap, a.isSameSite, a.isAmbiguous, a.isMirrored,
               a.isOnlySaid, a.runnerUpConfidence);
  if (numbers.isThere(a.best)) show(numbers, *a.best);
  if (numbers.isThere(a.runnerUp)) show(numbers, *a.runnerUp);
  for (Transform2D& pose : numbers.sized(a.poses)) show(numbers, pose);
}

void show(Numbers& numbers, FollowedWalls& walls) {
  show(numbers, walls.pose);
  numbers.show(walls.bend, walls.share, walls.misfit);
  for (FollowedPatch& patch : numbers.sized(walls.patches)) {
    numbers.show(patch.patch, patch.walls, patch.layer);
    show(numbers, patch.pose);
  }
}

void show(Numbers& numbers, MapPair& pair) {
  numbers.show(pair.areIdentical, pair.areEdits, pair.areStoreys);
  show(numbers, pair.alignment);
  show(numbers, pair.bInA);
  show(numbers, pair.aInB);
}

bool areOf(const FollowedWalls& walls, const WallMap& map) {
  return allOf(walls.patches, [&](const FollowedPatch& followed) {
    return followed.patch < map.patches.size() && followed.layer >= 0;
  });
}

double radiusOf(const WallMap& map) {
  return 0.5 * map.frame.resolution * std::hypot(map.frame.width, map.frame.height);
}

/** Whether maps and patches lie where two maps that meet can lie: elsewhere, the site would be as
 *  large as the pose is wrong. `walls` are those of b in a. */
bool canMeet(const FollowedWalls& walls, const WallMap& a, const WallMap& b) {
  const double farthest = 2 * (radiusOf(a) + radiusOf(b));
  const auto isNear = [&](const Transform2D& pose) {
    return norm(pose(b.middle()) - a.middle()) <= farthest;
  };
  return isNear(walls.pose) &&
         allOf(walls.patches, [&](const FollowedPatch& followed) { return isNear(followed.pose); });
}

bool canMeet(const MapPair& pair, const WallMap& a, const WallMap& b) {
  if (!pair.alignment.isSameSite) return true;  // then none of them is used
  FollowedWalls wholes;
  wholes.pose = pair.alignment.pose;
  for (const Transform2D& pose : pair.alignment.poses) wholes.patches.push_back({0, pose, 0, 0});
  return canMeet(wholes, a, b) && canMeet(pair.bInA, a, b) && canMeet(pair.aInB, b, a);
}

}  // namespace

RelatePair keepPairs(RelatePair relate, const std::vector<Run>& runs, const std::string& how,
                     const KeptPairs& kept) {
  if (!kept.read) return relate;
  auto prints = mapped(runs, [](const Run& run) { return fingerprint(run.map); });
  const std::string program = std::string(version()) + ' ' + kRelatedSources + ' ' + how;
  return [relate = std::move(relate), prints = std::move(prints), program, &runs, &kept](
             const PairOver& pair, FullMaps& maps) {
    std::string all = program + ' ' + prints[pair.a] + ' ' + prints[pair.b];
    if (pair.hub != pair.a && pair.hub != pair.b) all += ' ' + prints[pair.hub];
    const std::string name = sha256Of(viewOf(all));
    if (const auto bytes = kept.read(name))
      if (auto known = pairOfBytes(*bytes, runs[pair.a].map, runs[pair.b].map))
        return std::move(*known);
    MapPair found = relate(pair, maps);
    kept.write(name, pairBytes(found));
    return found;
  };
}

std::string fingerprint(const WallMap& map) {
  const GridFrame& frame = map.frame;
  std::vector<double> numbers{double(frame.width), double(frame.height), frame.resolution,
                              frame.origin.x,      frame.origin.y,       double(map.hasScans)};
  for (const WallPoint& wall : map.walls)
    numbers.insert(numbers.end(), {wall.place.x, wall.place.y, wall.normal.x, wall.normal.y});
  static_assert(sizeof(State) == 1);
  const std::string_view states(reinterpret_cast<const char*>(map.states.data()),
                                map.states.size());
  return sha256Of({reinterpret_cast<const std::uint8_t*>(numbers.data()), 8 * numbers.size()},
                  viewOf(states));
}

std::string pairBytes(const MapPair& pair) {
  MapPair shown = pair;
  Numbers numbers;
  show(numbers, shown);
  const std::string body = numbers.bytes();
  return std::string(kHead) + sha256Of(viewOf(body)) + body;
}

std::optional<MapPair> pairOfBytes(std::string_view bytes, const WallMap& a, const WallMap& b) {
  if (bytes.substr(0, kHead.size()) != kHead) return {};
  bytes.remove_prefix(kHead.size());
  const std::size_t checksum = sha256Of({}).size();
  if (bytes.size() < checksum) return {};
  const std::string_view body = bytes.substr(checksum);
  if (bytes.substr(0, checksum) != sha256Of(viewOf(body))) return {};
  MapPair pair;
  Numbers numbers(body);
  show(numbers, pair);
  if (!numbers.areAllRead() || !areOf(pair.bInA, b) || !areOf(pair.aInB, a) || !canMeet(pair, a, b))
    return {};
  return pair;
}

}  // namespace roomgraph
