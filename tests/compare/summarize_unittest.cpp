#include "summarize.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

using Names = std::vector<std::string>;

/** What was found of runs of one site, each related to each; all can be changed. */
struct Found {
  std::vector<roomgraph::Run> runs;
  MapPairs related;
  Site site;
  Consensus consensus;
  RunScores scores;
  std::vector<std::vector<MapBreak>> breaks;
  SiteMeasures measures;
  std::vector<WeldedKeyFrames> welded;
  std::vector<SiteRoom> rooms;

  /** Runs of these names with these errors; those behind `members` are of no site. */
  Found(const Names& names, const std::vector<double>& errors, std::size_t members)
      : runs(names.size()), related(names.size()) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      runs[i].name = names[i], runs[i].file = names[i] + ".simplemap";
      if (i >= members) continue;
      site.members.push_back(i);
      scores.emplace_back();
      scores.back().emplace();
      scores.back()->mapError = errors[i], scores.back()->isMeaningful = true;
      scores.back()->score = 100 - 100 * errors[i], scores.back()->low = scores.back()->score - 5;
      scores.back()->others = members - 1, scores.back()->share = 1;
    }
    for (const std::size_t i : site.members) site.runs.push_back(&runs[i]);
    site.poses.resize(members);
    consensus.errors = ById<RunId, MapError>(members);
    consensus.graph.runs = ById<RunId, GraphRun>(members);
    for (std::size_t i = 0; i < members; ++i) {
      consensus.graphRuns.push_back(RunId(i));
      consensus.siteRuns.add(i);
    }
    breaks.resize(members);
    measures.runs.resize(members), welded.resize(members);
    measures.pairs = PairTable<std::vector<Measure>>(members);
  }
  Found(const Found&) = delete;

  Comparison comparison() const {
    return summarize(runs, related,
                     {site, related, consensus, scores, breaks, measures, rooms, 0, welded});
  }
  Names order() const {
    Names names;
    for (const ComparedRun& run : comparison().runs) names.push_back(run.name);
    return names;
  }
  std::vector<std::size_t> ranks() const {
    std::vector<std::size_t> ranks;
    for (const ComparedRun& run : comparison().runs) ranks.push_back(run.rank);
    return ranks;
  }
};

TEST(Summarize, theLeastErrorComesFirst) {
  const Found found({"a", "b", "c"}, {0.3, 0.1, 0.2}, 3);
  EXPECT_EQ(found.order(), (Names{"b", "c", "a"}));
  EXPECT_EQ(found.ranks(), (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(found.comparison().verdict.rfind("b is the best map", 0), 0u);
}

TEST(Summarize, equalErrorsShareARankAndStandByName) {
  const Found found({"c", "a", "b", "d"}, {0.1, 0.1 + 1e-9, 0.1, 0.2}, 4);
  EXPECT_EQ(found.ranks(), (std::vector<std::size_t>{1, 1, 1, 4}));
  EXPECT_EQ(Found({"c", "a"}, {0.1, 0.1}, 2).order(), (Names{"a", "c"}));
}

TEST(Summarize, whatMeansLittleComesBehindWhatMeansMuchAndWhatHasNoScoreLast) {
  Found found({"small", "none", "good", "bad"}, {0.01, 0, 0.2, 0.9}, 4);
  found.scores[0]->isMeaningful = false;
  found.scores[1].reset();
  EXPECT_EQ(found.order(), (Names{"good", "bad", "small", "none"}));
  EXPECT_EQ(found.ranks(), (std::vector<std::size_t>{1, 2, 3, 0}));
}

TEST(Summarize, aMeaningfulRunDoesNotShareARankWithOneThatIsNot) {
  Found found({"a", "b"}, {0.1, 0.1}, 2);
  found.scores[1]->isMeaningful = false;
  EXPECT_EQ(found.ranks(), (std::vector<std::size_t>{1, 2}));
}

TEST(Summarize, runsOfNoSiteAreLeftOutWithAReason) {
  const Found found({"a", "b", "c"}, {0.1, 0.2}, 2);
  const Comparison comparison = found.comparison();
  ASSERT_EQ(comparison.leftOut.size(), 1u);
  EXPECT_EQ(comparison.leftOut[0].name, "c");
  EXPECT_EQ(comparison.leftOut[0].file, "c.simplemap");
  EXPECT_EQ(comparison.leftOut[0].reason, "does not lie in the same site as the others");
  EXPECT_TRUE(comparison.leftOut[0].isOtherSite);
  EXPECT_EQ(comparison.pairs.size(), 3u) << "how it lies to the others is told";
}

TEST(Summarize, aMirroredRunIsNamedAsSuch) {
  Found found({"a", "b", "c"}, {0.1, 0.2}, 2);
  found.related(0, 2).alignment.isMirrored = found.related(1, 2).alignment.isMirrored = true;
  EXPECT_EQ(found.comparison().leftOut[0].reason, "is mirrored: is the lidar mounted upside down?");
  found.related(1, 2).alignment.isMirrored = false;
  EXPECT_EQ(found.comparison().leftOut[0].reason, "does not lie in the same site as the others")
      << "one of two";
}

TEST(Summarize, anotherStoreyIsNamedAsSuch) {
  Found found({"a", "b", "c"}, {0.1, 0.2}, 2);
  found.related(0, 2).areStoreys = found.related(1, 2).areStoreys = true;
  EXPECT_EQ(found.comparison().leftOut[0].reason,
            "does not lie in the same site as the others; its outer walls agree, its inner ones do "
            "not: another storey?");
}

TEST(Summarize, otherSitesAreNamedWithTheirRuns) {
  Found found({"a", "b", "z", "y"}, {0.1, 0.2}, 2);
  found.site.others = {{2, 3}};
  const Comparison comparison = found.comparison();
  EXPECT_EQ(comparison.leftOut[0].reason, "lies in another site: y and z");
  EXPECT_TRUE(comparison.leftOut[0].hasMates);
  EXPECT_NE(comparison.verdict.find("There are 2 sites, of which this compares the first: {a "
                                    "and b}, {y and z}."),
            std::string::npos)
      << comparison.verdict;
}

TEST(Summarize, runsOfOneDriveAreACaveat) {
  Found found({"a", "b", "c"}, {0.1, 0.2, 0.3}, 3);
  for (const std::size_t run : {0u, 2u})
    for (std::uint64_t id = 1; id <= 20; ++id) {
      found.runs[run].scans.emplace_back();
      found.runs[run].scans.back().scanId = id;
      found.runs[run].scans.back().ends.add({1, 1});
    }
  for (const std::size_t run : {0u, 2u}) {
    found.consensus.errors[RunId(run)].errors.assign(20, 0.1);
    found.consensus.errors[RunId(run)].isSeen.assign(20, true);
  }
  EXPECT_NE(found.comparison().verdict.find("2 runs are of one drive (a and c)"), std::string::npos)
      << found.comparison().verdict;
}

TEST(Summarize, roomsSayWhatRunsSayInTheOrderOfTheRuns) {
  Found found({"a", "b", "c"}, {0.3, 0.1, 0.2}, 3);
  found.rooms.resize(1);
  for (const char* run : {"a", "b", "c"}) {
    found.rooms[0].runs.emplace_back();
    found.rooms[0].runs.back().run = run;
  }
  const Comparison comparison = found.comparison();
  ASSERT_EQ(comparison.rooms.size(), 1u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(comparison.rooms[0].runs[i].run, comparison.runs[i].name);
}

TEST(Summarize, measuresOfAPairAreThoseOfItsRuns) {
  Found found({"stranger", "a", "b"}, {}, 0);
  found.site.members = {1, 2};
  found.site.runs = {&found.runs[1], &found.runs[2]};
  found.site.poses.resize(2), found.consensus.errors = ById<RunId, MapError>(2),
                              found.breaks.resize(2);
  found.consensus.graph.runs = ById<RunId, GraphRun>(2);
  found.consensus.graphRuns = {RunId(0), RunId(1)};
  found.consensus.siteRuns = ById<RunId, std::size_t>(std::vector<std::size_t>{0, 1});
  found.scores.resize(2), found.measures.runs.resize(2), found.welded.resize(2);
  found.measures.pairs = PairTable<std::vector<Measure>>(2);
  found.measures.pairs(0, 1) = {{"bend", 0.25, "m", 500, {}, {}, true}};
  found.related(1, 2).alignment.confidence = 0.75;
  found.related(1, 2).alignment.isSameSite = true;
  for (const ComparedPair& pair : found.comparison().pairs) {
    const bool isOfSite = pair.a == "a" && pair.b == "b";
    EXPECT_EQ(pair.measures.size(), isOfSite ? 1u : 0u) << pair.a << pair.b;
    EXPECT_EQ(pair.confidence, isOfSite ? 0.75 : 0);
    EXPECT_EQ(pair.isSameSite, isOfSite);
    EXPECT_FALSE(pair.transform) << "a pose that no one has looked for";
  }
}

TEST(Summarize, theLargestBreakComesFirst) {
  Found found({"a", "b"}, {0.1, 0.2}, 2);
  found.breaks[0].resize(2), found.breaks[1].resize(2);
  found.breaks[0][0].run = found.breaks[0][1].run = "a";
  found.breaks[1][0].run = found.breaks[1][1].run = "b";
  found.breaks[0][0].shift = found.breaks[0][1].shift = 0.5;
  found.breaks[0][0].keyFrame = 10, found.breaks[0][1].keyFrame = 20;
  found.breaks[1][0].rotation = 0.04, found.breaks[1][1].rotation = -0.2;
  const Comparison comparison = found.comparison();
  ASSERT_EQ(comparison.breaks.size(), 4u);
  EXPECT_EQ(comparison.breaks[0].rotation, -0.2);
  EXPECT_EQ(comparison.breaks[1].keyFrame, 10u) << "equal ones along the run";
  EXPECT_EQ(comparison.breaks[2].keyFrame, 20u);
  EXPECT_EQ(comparison.breaks[3].rotation, 0.04);
  EXPECT_NE(comparison.runs[1].reason.find("breaks in 1 place"), std::string::npos)
      << "the other one is slight";
}

TEST(Summarize, theCoreAndTheReferenceAreNamed) {
  Found found({"b", "a", "c"}, {0.1, 0.2, 0.3}, 3);
  found.related.core = {0, 1};
  found.site.reference = 2;
  found.scores[2].reset();
  const Comparison comparison = found.comparison();
  EXPECT_EQ(comparison.core, (Names{"a", "b"})) << "by name";
  EXPECT_EQ(comparison.reference, "c");
  EXPECT_EQ(comparison.runs.back().reason, "the others are measured against it");
}

Run drive() {
  Run run;
  for (int k = 0; k < 3; ++k) {
    run.scans.emplace_back();
    run.scans.back().keyFrame = std::size_t(2 * k);
    run.scans.back().pose = {double(k), 2, 0.1};
    if (k > 0) run.scans.back().time = 1e9 + k;
  }
  return run;
}

TEST(RunPath, isThatOfTheRunInTheFrameOfTheSite) {
  const roomgraph::Run run = drive();
  MapError error;
  error.errors = {0.1, 0.2, 0.3};
  const Transform2D pose{10, -5, M_PI / 2};
  const std::vector<PathPose> path = runPath(run, pose, error);
  ASSERT_EQ(path.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(path[k].keyFrame, 2 * k) << "its number in the file, not among the scans";
    EXPECT_NEAR(path[k].pose.x, 8, 1e-12);
    EXPECT_NEAR(path[k].pose.y, -5 + double(k), 1e-12);
    EXPECT_NEAR(path[k].pose.phi, M_PI / 2 + 0.1, 1e-12);
    EXPECT_EQ(path[k].error, error.errors[k]);
    EXPECT_EQ(path[k].time, run.scans[k].time);
  }
}

TEST(RunPath, aCopyWithoutScansTellsNoErrors) {
  MapError ofPatches;
  ofPatches.errors = {0.1, 0.2};
  for (const PathPose& at : runPath(drive(), {}, ofPatches)) EXPECT_FALSE(at.error);
}

TEST(RunPath, whatNobodyBearsOutHasNoError) {
  MapError error;
  error.errors = {0.1, 0.2, 0.3}, error.isConfirmed = {true, false, true};
  const std::vector<PathPose> path = runPath(drive(), {}, error);
  EXPECT_EQ(path[0].error, 0.1);
  EXPECT_FALSE(path[1].error);
  EXPECT_EQ(path[2].error, 0.3);
}

TEST(RunPath, aRunWithoutScansHasNone) { EXPECT_TRUE(runPath({}, {}, {}).empty()); }

}  // namespace
}  // namespace roomgraph
