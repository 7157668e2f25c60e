#include "roomgraph/consensus/shared_drives.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

using Sets = std::vector<std::vector<std::size_t>>;

/** A run over the scans `first` to `last` of a log. */
roomgraph::Run over(std::uint64_t first, std::uint64_t last) {
  roomgraph::Run run;
  for (std::uint64_t id = first; id <= last; ++id) {
    run.scans.emplace_back();
    run.scans.back().scanId = id;
    run.scans.back().ends.add({1, 1});
  }
  return run;
}

Sets drivesOf(const std::vector<roomgraph::Run>& runs) {
  std::vector<const roomgraph::Run*> pointers;
  for (const roomgraph::Run& run : runs) pointers.push_back(&run);
  return sharedDrives(pointers);
}

TEST(SharedDrives, runsOverOneLogAreOfOneDrive) {
  EXPECT_EQ(drivesOf({over(1, 50), over(100, 150), over(1, 50)}), (Sets{{0, 2}}));
  EXPECT_EQ(drivesOf({over(1, 50), over(35, 85), over(70, 120)}), (Sets{{0, 1, 2}}))
      << "by way of the second";
  EXPECT_EQ(drivesOf({over(1, 9), over(50, 60), over(1, 9), over(52, 60)}), (Sets{{0, 2}, {1, 3}}));
}

TEST(SharedDrives, aFewScansInCommonAreNone) {
  EXPECT_TRUE(drivesOf({over(1, 50), over(45, 100)}).empty());
  EXPECT_TRUE(drivesOf({over(1, 50), {}, {}}).empty()) << "runs without scans";
  EXPECT_TRUE(drivesOf({}).empty());
}

}  // namespace
}  // namespace roomgraph
