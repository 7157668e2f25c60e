#include "roomgraph/mrpt_plugin/scene_file.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>

#include "mrpt_reads.h"
#include "sample_graph.h"

namespace roomgraph {
namespace {

TEST(SceneFile, isReadByMrptAndHoldsTheGraph) {
  MrptScene scene = test::sceneOf(sceneBytes(sampleGraph()));
  for (const char* name : {"room graph", "rooms", "corridors", "vertices", "map"})
    EXPECT_TRUE(scene.getByName(name)) << name;
  EXPECT_TRUE(scene.followCamera());
}

TEST(SceneFile, theCameraLooksAtTheMiddleFromAbove) {
  const MrptScene scene = graphScene(sampleGraph());
  const auto& camera = scene.getViewport()->getCamera();
  EXPECT_NEAR(camera.getPointingAtX(), 0, 1e-6);
  EXPECT_NEAR(camera.getPointingAtY(), 0, 1e-6);
  // 24 x 16 m in a field of view of 30 degrees.
  EXPECT_GT(camera.getZoomDistance(), 16 / 2 / std::tan(15 * M_PI / 180));
  EXPECT_LT(camera.getZoomDistance(), 60);
}

TEST(SceneFile, theSameGraphGivesTheSameBytes) {
  EXPECT_EQ(sceneBytes(sampleGraph()), sceneBytes(sampleGraph()));
}

TEST(SceneFile, anEmptyGraphHasAScene) { EXPECT_FALSE(sceneBytes({}).empty()); }

}  // namespace
}  // namespace roomgraph
