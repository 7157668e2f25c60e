#include "roomgraph/compare/run_names.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

using Names = std::vector<std::string>;

TEST(RunNames, aRunIsNamedAsItsFileWithoutFolderAndEnding) {
  EXPECT_EQ(runNames({"nights/mon.simplemap.gz", "tue.gridmap", "plan.png"}),
            (Names{"mon", "tue", "plan"}));
  EXPECT_TRUE(runNames({}).empty());
}

TEST(RunNames, filesOfOneNameAreToldApartByTheirFolders) {
  EXPECT_EQ(runNames({"mon/run.simplemap", "tue/run.simplemap", "wed/other.simplemap"}),
            (Names{"mon/run", "tue/run", "other"}));
}

TEST(RunNames, filesOfOneMapAreToldApartByTheirExtensions) {
  EXPECT_EQ(runNames({"maps/office.yaml", "maps/office.gridmap.gz", "maps/hall.yaml"}),
            (Names{"office.yaml", "office.gridmap.gz", "hall"}));
}

TEST(RunNames, whereThatDoesNotHelpTheWholeFileIsTheName) {
  EXPECT_EQ(runNames({"a/mon/run.yaml", "b/mon/run.yaml", "tue/run.yaml"}),
            (Names{"a/mon/run.yaml", "b/mon/run.yaml", "tue/run"}));
}

TEST(RunNames, aFileThatIsGivenAgainGetsANumber) {
  EXPECT_EQ(runNames({"run.yaml", "run.yaml", "run.yaml"}), (Names{"run", "run#2", "run#3"}));
  EXPECT_EQ(runNames({"run.yaml", "run#2.yaml", "run.yaml"}), (Names{"run", "run#2", "run#3"}));
}

TEST(RunNames, theOrderOfFilesDoesNotMatter) {
  const Names one = runNames({"x/run.yaml", "y/run.yaml", "z.yaml"});
  EXPECT_EQ(runNames({"z.yaml", "y/run.yaml", "x/run.yaml"}), (Names{one[2], one[1], one[0]}));
}

TEST(RunNames, namesAreUtf8AndDifferent) {
  const Names names = runNames({"caf\xe9.yaml", "caf\xe8.yaml"});
  EXPECT_EQ(names[0].rfind("caf\xef\xbf\xbd", 0), 0u);
  EXPECT_NE(names[0], names[1]);
}

}  // namespace
}  // namespace roomgraph
