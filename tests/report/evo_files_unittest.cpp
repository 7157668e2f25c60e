#include "roomgraph/report/evo_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace roomgraph {
namespace {

/** Four scans along x, 1 m and 2 s apart; the third has no error. */
ComparedRun straightRun() {
  ComparedRun run;
  run.name = "straight";
  for (std::size_t k = 0; k < 4; ++k)
    run.path.push_back({10 + k, 100.5 + 2.0 * double(k), {double(k), 5, 0}, 0.1 * double(k)});
  run.path[2].error.reset();
  return run;
}

/** The bytes of a file of an archive whose files are stored as they are. */
std::string fileIn(const std::string& zip, const std::string& name) {
  std::size_t at = zip.find(name);
  while (at != std::string::npos && (at < 30 || zip.compare(at - 30, 4, "PK\3\4") != 0))
    at = zip.find(name, at + 1);
  if (at == std::string::npos) return "";
  std::uint32_t size = 0;
  std::memcpy(&size, &zip[at - 8], 4);
  return zip.substr(at + name.size(), size);
}

std::vector<double> valuesIn(const std::string& zip, const std::string& name) {
  const std::string npy = fileIn(zip, name);
  const std::size_t end = npy.find('\n');
  if (npy.rfind("\x93NUMPY", 0) != 0 || (end + 1) % 64 != 0) return {};
  std::vector<double> values((npy.size() - end - 1) / 8);
  std::memcpy(values.data(), &npy[end + 1], values.size() * 8);
  EXPECT_NE(npy.find("'shape': (" + std::to_string(values.size()) + ",)"), std::string::npos);
  return values;
}

TEST(PathTum, isALineForEachScanInTheFrameOfTheSite) {
  ComparedRun run = straightRun();
  run.path.resize(2);
  run.path[1].pose.phi = M_PI / 2;
  EXPECT_EQ(pathTum(run),
            "100.500000 0.0000 5.0000 0 0 0 0.000000000 1.000000000\n"
            "102.500000 1.0000 5.0000 0 0 0 0.707106781 0.707106781\n");
  run.path[0].time.reset();
  EXPECT_EQ(pathTum(run).substr(0, 10), "10.000000 ");
  EXPECT_NE(pathTum(run).find("\n11.000000 "), std::string::npos);
  EXPECT_EQ(pathTum(ComparedRun{}), "");
}

TEST(EvoResult, tellsTheErrorsThatAreKnownAndWhereTheyAre) {
  const std::string zip = evoResult(straightRun(), "a_run");
  EXPECT_EQ(valuesIn(zip, "error_array.npy"), (std::vector<double>{0, 0.1, 0.1 * 3}));
  EXPECT_EQ(valuesIn(zip, "distances_from_start.npy"), (std::vector<double>{0, 1, 3}));
  EXPECT_EQ(valuesIn(zip, "seconds_from_start.npy"), (std::vector<double>{0, 2, 6}));
  EXPECT_EQ(valuesIn(zip, "timestamps.npy"), (std::vector<double>{100.5, 102.5, 106.5}));
  EXPECT_EQ(fileIn(zip, "a_run.tum"), pathTum(straightRun()));
  EXPECT_NE(fileIn(zip, "info.json").find("\"est_name\":\"a_run.tum\""), std::string::npos);
}

TEST(EvoResult, hasEvosStatistics) {
  ComparedRun run = straightRun();
  run.path.resize(2);
  run.path[0].error = 3, run.path[1].error = 4;
  const std::string stats = fileIn(evoResult(run, "r"), "stats.json");
  EXPECT_EQ(stats,
            "{\"max\":4.0,\"mean\":3.5,\"median\":3.5,\"min\":3.0,\"rmse\":3.5355339059327378,"
            "\"sse\":25.0,\"std\":0.5}");
}

TEST(EvoResult, withoutTimesHasNone) {
  ComparedRun run = straightRun();
  run.path[3].time.reset();
  const std::string zip = evoResult(run, "r");
  EXPECT_EQ(valuesIn(zip, "error_array.npy").size(), 3u);
  EXPECT_EQ(fileIn(zip, "timestamps.npy"), "");
}

TEST(EvoResult, isEmptyWhereNoErrorIsKnown) {
  ComparedRun run = straightRun();
  for (PathPose& at : run.path) at.error.reset();
  EXPECT_EQ(evoResult(run, "r"), "");
  EXPECT_EQ(evoResult(ComparedRun{}, "r"), "");
}

}  // namespace
}  // namespace roomgraph
