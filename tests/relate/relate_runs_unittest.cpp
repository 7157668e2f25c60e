#include "roomgraph/relate/relate_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <map>

#include "choose_runs.h"
#include "drawn_building.h"
#include "keep_pairs.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/checked_file.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

roomgraph::Run run(const Grid& grid) {
  roomgraph::Run run;
  run.map = wallMap(grid);
  return run;
}

std::vector<roomgraph::Run> fourRuns() {
  return {run(bent(drawnBuilding(1, {3, -4, 0.4}), 0.08)), run(drawnBuilding(1, {-7, 2, 2.5})),
          run(drawnBuilding(1, {0, 1, -1.2})), run(drawnBuilding(11, {}))};
}

bool arePosesAlike(const Transform2D& l, const Transform2D& r) {
  return distance(l.shift(), r.shift()) < 0.1 && std::abs(wrappedAngle(l.phi - r.phi)) < 0.01;
}

TEST(RelateRuns, theHubIsTheStraightestOfTheLargeRuns) {
  std::vector<roomgraph::Run> runs = fourRuns();
  runs.resize(3);
  const std::size_t hub = byStraightness(runs).front();
  EXPECT_NE(hub, 0u) << "it is bent";
  runs[hub].map.freeArea = 1;
  EXPECT_NE(byStraightness(runs).front(), hub) << "it is small";
}

TEST(RelateRuns, overTheHubComesOutWhatASearchFinds) {
  const std::vector<roomgraph::Run> runs = fourRuns();
  const MapPairs related = test::related(runs);
  for (const auto& [a, b] : pairsOf(runs.size())) {
    const MapPair& over = related(a, b);
    const MapPair searched = relateMaps(runs[a].map, runs[b].map);
    EXPECT_EQ(over.alignment.isSameSite, searched.alignment.isSameSite) << a << ' ' << b;
    EXPECT_EQ(over.alignment.isSameSite, b < 3);
    if (b == 3) continue;
    EXPECT_TRUE(arePosesAlike(over.alignment.pose, searched.alignment.pose)) << a << ' ' << b;
    EXPECT_NEAR(over.bInA.bend, searched.bInA.bend, 0.03);
    EXPECT_NEAR(over.aInB.bend, searched.aInB.bend, 0.03);
  }
}

/** Keeps pairs in memory, and counts. */
struct Shelf {
  std::map<std::string, std::string> bytes;
  std::size_t written = 0;

  KeptPairs kept() {
    return {[this](const std::string& name) -> std::optional<std::string> {
              const auto found = bytes.find(name);
              if (found == bytes.end()) return {};
              return found->second;
            },
            [this](const std::string& name, const std::string& of) {
              bytes[name] = of;
              ++written;
            }};
  }
};

std::vector<std::string> bytesOf(const MapPairs& pairs) {
  std::vector<std::string> bytes;
  for (const MapPair& pair : pairs.values()) bytes.push_back(pairBytes(pair));
  return bytes;
}

TEST(RelateRuns, keptPairsChangeNothingAndAreNotWorkedOutAgain) {
  const std::vector<roomgraph::Run> runs = fourRuns();
  const auto without = bytesOf(test::related(runs));
  Shelf shelf;
  EXPECT_EQ(bytesOf(test::related(runs, shelf.kept())), without);
  EXPECT_EQ(shelf.written, 6u);
  EXPECT_EQ(bytesOf(test::related(runs, shelf.kept())), without);
  EXPECT_EQ(shelf.written, 6u);
}

TEST(RelateRuns, oneMoreRunCostsItsOwnPairsOnly) {
  std::vector<roomgraph::Run> runs = fourRuns();
  const auto all = bytesOf(test::related(runs));
  const std::size_t hub = byStraightness(runs).front(), added = hub == 0 ? 1 : 0;
  std::vector<roomgraph::Run> before = runs;
  before.erase(before.begin() + std::ptrdiff_t(added));
  Shelf shelf;
  test::related(before, shelf.kept());
  EXPECT_EQ(shelf.written, 3u);
  EXPECT_EQ(bytesOf(test::related(runs, shelf.kept())), all);
  EXPECT_EQ(shelf.written, 6u);
}

/** Ten runs, seven of one building and three of another, and where these lie in them. */
struct TenRuns {
  std::vector<roomgraph::Run> runs;
  std::vector<Transform2D> poses;  // run <- building

  TenRuns() {
    for (int i = 0; i < 10; ++i) {
      poses.push_back({double(i), 2.0 * i, wrappedAngle(0.7 * i)});
      runs.push_back(run(drawnBuilding(i < 7 ? 1 : 11, poses.back())));
      runs.back().name = std::to_string(i);
    }
  }
};

MapPairs relatedByCore(const std::vector<roomgraph::Run>& runs, std::size_t core) {
  RelateRunsOptions options;
  options.core = core;
  return relateRuns(runs, options, oneByOne);
}

TEST(RelateRuns, ofManyRunsEachIsRelatedToSomeOfTheCore) {
  const TenRuns ten;
  const MapPairs related = relatedByCore(ten.runs, 3);
  ASSERT_EQ(related.core.size(), 6u) << "three of each building";
  for (std::size_t run = 0; run < ten.runs.size(); ++run) {
    std::size_t judges = 0;
    for (const std::size_t judge : related.core)
      judges += judge != run && related(judge, run).alignment.isSameSite;
    EXPECT_GE(judges, 2u) << run;
  }
  EXPECT_LT(related.pairs().size(), 45u);
  for (const auto& [a, b] : related.pairs()) {
    const Alignment& alignment = related(a, b).alignment;
    EXPECT_EQ(alignment.isSameSite, (a < 7) == (b < 7)) << a << ' ' << b;
    const Transform2D truth = ten.poses[a] * ten.poses[b].inverse();
    EXPECT_TRUE(!alignment.isSameSite || arePosesAlike(alignment.pose, truth)) << a << ' ' << b;
  }
}

TEST(RelateRuns, aReferenceIsOfTheCoreAndRelatedToAllOfItsSite) {
  std::vector<roomgraph::Run> runs = TenRuns().runs;
  runs.resize(7);
  RelateRunsOptions options;
  options.core = 3, options.reference = 6;
  runs[6].map.freeArea = 1;  // it would not be chosen
  const MapPairs related = relateRuns(runs, options, oneByOne);
  EXPECT_TRUE(std::count(related.core.begin(), related.core.end(), 6u));
  for (std::size_t run = 0; run < 6; ++run) EXPECT_TRUE(related.has(run, 6)) << run;
}

TEST(RelateRuns, aCopyIsRelatedToItsFirstOne) {
  std::vector<roomgraph::Run> runs = TenRuns().runs;
  runs.resize(6);
  runs.push_back(runs[5]);
  EXPECT_TRUE(relatedByCore(runs, 3)(5, 6).areIdentical);
}

TEST(RelateRuns, aDamagedPairIsWorkedOutAgain) {
  std::vector<roomgraph::Run> runs = fourRuns();
  runs.resize(2);
  Shelf shelf;
  const auto whole = bytesOf(test::related(runs, shelf.kept()));
  const std::string bytes = shelf.bytes.begin()->second;
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 200) {
    std::string damaged = bytes;
    damaged[at] = char(damaged[at] ^ 4);
    EXPECT_FALSE(pairOfBytes(damaged, runs[0].map, runs[1].map)) << at;
    EXPECT_FALSE(pairOfBytes(bytes.substr(0, at), runs[0].map, runs[1].map)) << at;
  }
  EXPECT_FALSE(pairOfBytes(bytes + 'x', runs[0].map, runs[1].map));
  shelf.bytes.begin()->second.back() ^= 1;
  EXPECT_EQ(bytesOf(test::related(runs, shelf.kept())), whole);
  EXPECT_EQ(shelf.bytes.begin()->second, bytes);
}

TEST(RelateRuns, aPairThatCannotBeOfItsMapsIsWorkedOutAgain) {
  std::vector<roomgraph::Run> runs = fourRuns();
  runs.resize(2);
  const WallMap &a = runs[0].map, &b = runs[1].map;
  const MapPair good = test::related(runs)(0, 1);
  ASSERT_FALSE(good.bInA.patches.empty());
  ASSERT_TRUE(pairOfBytes(pairBytes(good), a, b));
  const auto isTaken = [&](const std::function<void(MapPair&)>& change) {
    MapPair bad = good;
    change(bad);
    return pairOfBytes(pairBytes(bad), a, b).has_value();  // with the right checksum
  };
  const auto last = std::uint32_t(b.patches.size() - 1);
  EXPECT_TRUE(isTaken([&](MapPair& pair) { pair.bInA.patches[0].patch = last; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.bInA.patches[0].patch = last + 1; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.aInB.patches[0].patch = 4000000000; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.aInB.patches[0].layer = -1; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.alignment.pose.x = NAN; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.alignment.poses[0].phi = HUGE_VAL; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.alignment.confidence = NAN; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.bInA.bend = 1e300; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.alignment.pose.x = 1e6; }));
  EXPECT_FALSE(isTaken([&](MapPair& pair) { pair.bInA.patches[0].pose.y = -1e6; }));
}

TEST(RelateRuns, noNumberInAPairIsTooLargeForItsPlace) {
  std::vector<roomgraph::Run> runs = fourRuns();
  runs.resize(2);
  const std::string good = pairBytes(test::related(runs)(0, 1));
  const std::size_t checksum = good.find('\n') + 1, body = checksum + 64;
  for (std::size_t at = body; at < std::min(good.size(), body + 200 * sizeof(double));
       at += sizeof(double))
    for (const double value : {1e300, -1e300, 4e9, -1.0, 0.5, HUGE_VAL, double(NAN)}) {
      std::string bad = good;
      std::memcpy(&bad[at], &value, sizeof value);
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(bad.data());
      bad.replace(checksum, 64, sha256Of({bytes + body, bad.size() - body}));
      pairOfBytes(bad, runs[0].map, runs[1].map);  // UBSan looks at the casts, ASan at the sizes
    }
}

TEST(RelateRuns, aPairIsKeptForTheMapsThatItIsOf) {
  const WallMap map = wallMap(drawnBuilding(1, {}));
  WallMap moved = map, opened = map;
  moved.frame.origin.x += 0.01;
  opened.states[opened.states.size() / 2] = State::unknown;
  EXPECT_EQ(fingerprint(map), fingerprint(wallMap(drawnBuilding(1, {}))));
  EXPECT_NE(fingerprint(map), fingerprint(moved));
  EXPECT_NE(fingerprint(map), fingerprint(opened));
}

}  // namespace
}  // namespace roomgraph
