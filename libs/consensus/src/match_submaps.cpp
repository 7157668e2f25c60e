#include "roomgraph/consensus/match_submaps.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "fitted_consensus.h"
#include "likeness.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/consensus/track_scans.h"

namespace roomgraph {
namespace {

/** Counts which submaps of the other run drew the walls that a submap meets there. */
class Meeting {
 public:
  Meeting(const DrawnMap& in, const Transform2D& pose) : in_(in), forth_(pose) {}

  void add(const WallPoint& point) {
    ++all_;
    const Point at = forth_(point.place);
    const WallPoint* wall =
        nearestWall(in_.map, cellIndexAt(in_.map.frame, at), forth_.turned(point.normal));
    if (!wall || distance(wall->place, at) > kSameWall) return;
    ++found_;
    const auto first = in_.drawnBy.firsts.begin() + (wall - in_.map.walls.data());
    for (std::uint32_t k = first[0]; k < first[1]; ++k) ++met_[in_.drawnBy.submaps[k]];
  }

  double share() const { return all_ > 0 ? found_ / all_ : 0; }

  /** The submap met most, of equal ones the first. */
  std::optional<std::uint32_t> mostMet() const {
    std::optional<std::uint32_t> most;
    for (const auto& [submap, count] : met_)
      if (!most || count > met_.at(*most)) most = submap;
    return most;
  }

 private:
  DrawnMap in_;
  Motion2D forth_;
  double all_ = 0, found_ = 0;
  std::map<std::uint32_t, int> met_;
};

/** The match of a submap that lies at `pose` (in <- of), if enough of it is there. */
std::optional<SubmapMatch> matchAt(std::uint32_t submap, const Transform2D& submapPose,
                                   const Transform2D& pose, const Meeting& meeting,
                                   const RunSubmaps& inSubmaps) {
  const auto in = meeting.mostMet();
  if (!in || meeting.share() < fitted::kLeastFound) return std::nullopt;
  const Transform2D relative = inSubmaps.submaps[*in].pose.inverse() * pose * submapPose;
  return SubmapMatch{submap, *in, relative, meeting.share(), false};
}

std::vector<MatchedPiece> matchPatches(const Run& of, const RunSubmaps& ofSubmaps,
                                       const DrawnMap& in, const FollowedWalls& followed) {
  std::map<int, MatchedPiece> layers;
  for (const FollowedPatch& patch : followed.patches) {
    Meeting meeting(in, patch.pose);
    for (const std::uint32_t wall : of.map.patches[patch.patch].own)
      meeting.add(of.map.walls[wall]);
    const Transform2D& submap = ofSubmaps.submaps[patch.patch].pose;
    if (const auto match = matchAt(patch.patch, submap, patch.pose, meeting, in.submaps))
      layers[patch.layer].matches.push_back(*match);
  }
  std::vector<MatchedPiece> pieces;
  for (auto& [layer, piece] : layers) pieces.push_back(std::move(piece));
  return pieces;
}

using Track = std::vector<std::optional<Transform2D>>;  // in <- run, of each scan

/** Compares the map where each piece was found with where the others would have it. */
void tellLikeness(std::vector<MatchedPiece>& pieces, const Track& track, const Run& of,
                  const WallMap& in) {
  const auto middleOf = [](const MatchedPiece& piece) {
    return piece.matches[piece.matches.size() / 2].submap;
  };
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      if (pieces[a].matches.empty() || pieces[b].matches.empty()) continue;
      const std::uint32_t k = middleOf(pieces[a]);
      const Transform2D &here = *track[k], &there = *track[middleOf(pieces[b])];
      if (areNear(here, there, of.scans[k].at(), kBesideItself)) continue;
      const double likeness = likenessUnder(there * here.inverse(), in);
      MatchedPiece& smaller =
          pieces[b].matches.size() <= pieces[a].matches.size() ? pieces[b] : pieces[a];
      smaller.likeness = std::max(smaller.likeness, likeness);
    }
}

}  // namespace

std::vector<MatchedPiece> matchSubmaps(const Run& of, const RunSubmaps& ofSubmaps,
                                       const DrawnMap& in, const FollowedWalls& followed,
                                       const std::vector<Transform2D>& wholes) {
  if (followed.patches.empty()) return {};
  if (!ofSubmaps.areScans) return matchPatches(of, ofSubmaps, in, followed);
  const auto track = trackScans(of.scans, of.map.patches, followed, wholes, in.map, {});
  std::vector<MatchedPiece> pieces;
  std::optional<std::size_t> last;
  for (std::uint32_t k = 0; k < track.size(); ++k) {
    if (!track[k]) continue;
    if (!last || !areNear(*track[*last], *track[k], of.scans[k].at(), kSteadyTrack))
      pieces.emplace_back();  // the track jumps
    last = k;
    Meeting meeting(in, *track[k]);
    for (const WallPoint& point : of.scans[k].walls) meeting.add(point);
    const auto match = matchAt(k, ofSubmaps.submaps[k].pose, *track[k], meeting, in.submaps);
    if (match) pieces.back().matches.push_back(*match);
  }
  tellLikeness(pieces, track, of, in.map);
  return pieces;
}

std::vector<SubmapMatch> sameScans(const Run& a, const Run& b) {
  std::unordered_map<std::uint64_t, std::uint32_t> inB;
  for (std::uint32_t k = 0; k < b.scans.size(); ++k)
    if (b.scans[k].ends.count > 0) inB.emplace(b.scans[k].scanId, k);
  std::vector<SubmapMatch> matches;
  for (std::uint32_t k = 0; k < a.scans.size(); ++k) {
    const auto same = inB.find(a.scans[k].scanId);
    if (a.scans[k].ends.count > 0 && same != inB.end())
      matches.push_back({k, same->second, {}, 1, true});
  }
  return matches;
}

}  // namespace roomgraph
