#include "roomgraph/consensus/match_submaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

const Transform2D kThere{12, -7, 0.6};

/** A building, drawn by runs that lie in frames of their own. */
struct Building {
  Grid grid = test::drawnBuilding(4, {});
  std::vector<Keyframe> frames = test::drawnDrive(grid);

  roomgraph::Run run(const Transform2D& pose, bool hasScans) const {
    roomgraph::Run run;
    run.map = wallMap(test::drawnBuilding(4, pose), {});
    if (hasScans) run.scans = scanWalls(test::moved(frames, pose));
    return run;
  }
};

const Building& building() {
  static const Building the;
  return the;
}

std::vector<MatchedPiece> piecesOf(const roomgraph::Run& of, const roomgraph::Run& in,
                                   const Transform2D& pose) {
  return matchSubmaps(of, runSubmaps(of), {in.map, runSubmaps(in), drawnBy(in, in.map)},
                      followWalls(of.map, in.map, {pose}, {}), {pose});
}

/** All matches of a run in another, whose pose in it is known. */
std::vector<SubmapMatch> matchesOf(const roomgraph::Run& of, const roomgraph::Run& in,
                                   const Transform2D& pose) {
  std::vector<SubmapMatch> all;
  for (const MatchedPiece& piece : piecesOf(of, in, pose))
    all.insert(all.end(), piece.matches.begin(), piece.matches.end());
  return all;
}

void expectTrue(const std::vector<SubmapMatch>& matches, const roomgraph::Run& of,
                const roomgraph::Run& in) {
  const RunSubmaps ofSubmaps = runSubmaps(of), inSubmaps = runSubmaps(in);
  std::set<std::uint32_t> found;
  for (const SubmapMatch& match : matches) {
    const Transform2D in0 = inSubmaps.submaps[match.in].pose;
    const Transform2D truth = in0.inverse() * kThere * ofSubmaps.submaps[match.submap].pose;
    EXPECT_LT(distance(match.pose.shift(), truth.shift()), 0.15) << match.submap;
    EXPECT_NEAR(wrappedAngle(match.pose.phi - truth.phi), 0, 0.03) << match.submap;
    EXPECT_LT(norm(match.pose.shift()), 10) << "they have drawn the same walls";
    EXPECT_GE(match.weight, 0.45);
    EXPECT_LE(match.weight, 1);
    EXPECT_FALSE(match.isSameScan);
    found.insert(match.submap);
  }
  EXPECT_GT(double(found.size()), 0.9 * double(ofSubmaps.submaps.size()));
}

TEST(MatchSubmaps, eachScanLiesInTheOtherRunWhereItWasTaken) {
  const roomgraph::Run of = building().run({}, true), in = building().run(kThere, true);
  expectTrue(matchesOf(of, in, kThere), of, in);
}

TEST(MatchSubmaps, eachPatchLiesInTheOtherRunWhereItWasDrawn) {
  const roomgraph::Run of = building().run({}, false), in = building().run(kThere, false);
  expectTrue(matchesOf(of, in, kThere), of, in);
}

TEST(MatchSubmaps, scansAndPatchesFindEachOther) {
  const roomgraph::Run scans = building().run({}, true), patches = building().run(kThere, false);
  expectTrue(matchesOf(scans, patches, kThere), scans, patches);
}

TEST(MatchSubmaps, aScanThatIsItsOwnIsMatchedWithItself) {
  const roomgraph::Run run = building().run({}, true);
  const auto matches = matchesOf(run, run, {});
  for (const SubmapMatch& match : matches) EXPECT_LT(norm(match.pose.shift()), 1.5) << match.in;
  EXPECT_EQ(matches.size(), run.scans.size());
}

TEST(MatchSubmaps, inAnotherBuildingThereAreNone) {
  const roomgraph::Run run = building().run({}, true), flat = building().run({}, false);
  roomgraph::Run other;
  other.map = wallMap(test::squareHall({300, 0, 0}), {});
  EXPECT_TRUE(matchesOf(run, other, {}).empty());
  EXPECT_TRUE(matchesOf(flat, other, {}).empty());
  const RunSubmaps own = runSubmaps(run);
  EXPECT_TRUE(matchSubmaps(run, own, {run.map, own, drawnBy(run, run.map)}, {}, {}).empty())
      << "where no wall was followed";
}

TEST(MatchSubmaps, aTornRunIsFoundInTwoPieces) {
  const roomgraph::Run in = building().run({}, true);
  roomgraph::Run of = in;
  of.scans = scanWalls(test::broken(building().frames, 18, 0.4, {1, 2}));
  const auto pieces = piecesOf(of, in, {});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].matches.front().submap, 0u);
  EXPECT_EQ(pieces[0].matches.back().submap, 17u);
  EXPECT_EQ(pieces[1].matches.front().submap, 18u);
  for (const MatchedPiece& piece : pieces) EXPECT_LT(piece.likeness, 0.5) << "no wing is alike";
  EXPECT_EQ(piecesOf(in, in, {}).size(), 1u) << "a sound one is in one piece";
}

/** Scans that are named, with an end each. */
roomgraph::Run named(const std::vector<std::uint64_t>& ids) {
  roomgraph::Run run;
  for (const std::uint64_t id : ids) {
    run.scans.emplace_back();
    run.scans.back().scanId = id;
    run.scans.back().ends.add({1, 0});
  }
  return run;
}

TEST(SameScans, areThoseOfOneLog) {
  const auto same = sameScans(named({11, 12, 13, 14}), named({14, 99, 12}));
  ASSERT_EQ(same.size(), 2u);
  EXPECT_EQ(same[0].submap, 1u);
  EXPECT_EQ(same[0].in, 2u);
  EXPECT_EQ(same[1].submap, 3u);
  EXPECT_EQ(same[1].in, 0u);
  for (const SubmapMatch& match : same) {
    EXPECT_TRUE(match.isSameScan);
    EXPECT_EQ(norm(match.pose.shift()), 0);
    EXPECT_EQ(match.pose.phi, 0);
    EXPECT_EQ(match.weight, 1);
  }
}

TEST(SameScans, ofOtherLogsThereAreNone) {
  EXPECT_TRUE(sameScans(named({1, 2, 3}), named({4, 5})).empty());
  EXPECT_TRUE(sameScans(named({}), named({4, 5})).empty());
}

TEST(SameScans, aScanThatMetNothingIsNone) {
  roomgraph::Run blind = named({1, 2});
  blind.scans[0].ends = {};
  EXPECT_EQ(sameScans(blind, named({1, 2})).size(), 1u);
  EXPECT_EQ(sameScans(named({1, 2}), blind).size(), 1u);
}

}  // namespace
}  // namespace roomgraph
