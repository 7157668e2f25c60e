#include "keep_pairs.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "related_sources.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/version.h"

namespace roomgraph {
namespace {

constexpr std::string_view kHead = "roomgraph/pair\n";

// Both archives take every number as a double, which holds all of them exactly.

class Writer {
 public:
  template <typename T>
  void number(const T& value) {
    const double wide = double(value);
    char raw[sizeof wide];
    std::memcpy(raw, &wide, sizeof wide);
    bytes_.append(raw, sizeof wide);
  }
  template <typename... T>
  void numbers(const T&... values) {
    (number(values), ...);
  }
  template <typename T>
  std::size_t count(const T& of) {
    number(of.size());
    return of.size();
  }
  template <typename T>
  bool isThere(const std::optional<T>& value) {
    number(value.has_value());
    return value.has_value();
  }
  std::string bytes() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/** Once the bytes have run out, all that is read is 0. */
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  void number(T& value) {
    double wide = 0;
    isWhole_ = isWhole_ && bytes_.size() >= sizeof wide;
    if (isWhole_) {
      std::memcpy(&wide, bytes_.data(), sizeof wide);
      bytes_.remove_prefix(sizeof wide);
    }
    value = T(wide);
  }
  template <typename... T>
  void numbers(T&... values) {
    (number(values), ...);
  }
  template <typename T>
  std::size_t count(T& of) {
    std::size_t size = 0;
    number(size);
    isWhole_ = isWhole_ && size <= bytes_.size();
    of.resize(isWhole_ ? size : 0);
    return of.size();
  }
  template <typename T>
  bool isThere(std::optional<T>& value) {
    bool isThere = false;
    number(isThere);
    if (isThere) value.emplace();
    return isThere;
  }
  bool isAtEnd() const { return isWhole_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool isWhole_ = true;
};

// One list of fields for both ways.

template <typename Archive, typename Pose>
void visitPose(Archive& archive, Pose& pose) {
  archive.numbers(pose.x, pose.y, pose.phi);
}

template <typename Archive, typename Candidate>
void visitCandidate(Archive& archive, Candidate& c) {
  visitPose(archive, c.pose);
  auto& e = c.evidence;
  archive.numbers(e.close, e.loose, e.slightly, e.contradicted, e.known, e.all, e.weakest,
                  e.overlap, e.common, e.freeOnWall, c.score);
}

template <typename Archive, typename AnAlignment>
void visitAlignment(Archive& archive, AnAlignment& a) {
  visitPose(archive, a.pose);
  archive.numbers(a.confidence, a.siteConfidence, a.overlap, a.isSameSite, a.isAmbiguous,
                  a.isMirrored, a.isOnlySaid, a.runnerUpConfidence);
  if (archive.isThere(a.best)) visitCandidate(archive, *a.best);
  if (archive.isThere(a.runnerUp)) visitCandidate(archive, *a.runnerUp);
  const std::size_t poses = archive.count(a.poses);
  for (std::size_t i = 0; i < poses; ++i) visitPose(archive, a.poses[i]);
}

template <typename Archive, typename Walls>
void visitWalls(Archive& archive, Walls& walls) {
  visitPose(archive, walls.pose);
  archive.numbers(walls.bend, walls.share, walls.misfit);
  const std::size_t patches = archive.count(walls.patches);
  for (std::size_t i = 0; i < patches; ++i) {
    auto& patch = walls.patches[i];
    archive.numbers(patch.patch, patch.walls, patch.layer);
    visitPose(archive, patch.pose);
  }
}

template <typename Archive, typename Pair>
void visitPair(Archive& archive, Pair& pair) {
  archive.numbers(pair.areIdentical, pair.areEdits, pair.areStoreys);
  visitAlignment(archive, pair.alignment);
  visitWalls(archive, pair.bInA);
  visitWalls(archive, pair.aInB);
}

/** No pair may lead to patches that are not there. */
bool areOf(const FollowedWalls& walls, const WallMap& map) {
  return std::all_of(walls.patches.begin(), walls.patches.end(),
                     [&](const FollowedPatch& f) { return f.patch < map.patches.size(); });
}

}  // namespace

RelatePair keepPairs(RelatePair relate, const std::vector<Run>& runs, const std::string& how,
                     const KeptPairs& kept) {
  if (!kept.read) return relate;
  std::vector<std::string> prints;
  for (const Run& run : runs) prints.push_back(fingerprint(run.map));
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
  Writer writer;
  const GridFrame& frame = map.frame;
  writer.number(frame.width), writer.number(frame.height), writer.number(frame.resolution);
  writer.number(frame.origin.x), writer.number(frame.origin.y);
  writer.number(map.hasScans);  // followWalls asks for it
  for (const WallPoint& wall : map.walls) {
    writer.number(wall.place.x), writer.number(wall.place.y);
    writer.number(wall.normal.x), writer.number(wall.normal.y);
  }
  static_assert(sizeof(State) == 1);
  const std::string_view states(reinterpret_cast<const char*>(map.states.data()),
                                map.states.size());
  return sha256Of(viewOf(writer.bytes()), viewOf(states));
}

std::string pairBytes(const MapPair& pair) {
  Writer writer;
  visitPair(writer, pair);
  const std::string body = writer.bytes();
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
  Reader reader(body);
  visitPair(reader, pair);
  if (!reader.isAtEnd() || !areOf(pair.bInA, b) || !areOf(pair.aInB, a)) return {};
  return pair;
}

}  // namespace roomgraph
