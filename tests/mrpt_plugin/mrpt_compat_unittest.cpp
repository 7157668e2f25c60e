#include "roomgraph/mrpt_plugin/mrpt_compat.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

namespace roomgraph {
namespace {

// A viewport's light as MRPT has it in different versions.
struct Light25 {
  std::array<float, 4> diffuse{0.8f, 0.8f, 0.8f, 1}, ambient{0.2f, 0.2f, 0.2f, 1},
      specular{1, 1, 1, 1};
};
struct Light215 {
  float diffuse = 0.8f, ambient = 0.2f, specular = 0.95f;
};
struct Light3 {
  std::vector<int> lights{1};
  float ambient = 0.2f;
};

TEST(MrptCompat, lightIsEvenInEveryVersion) {
  Light25 colours;
  makeEven(colours);
  EXPECT_EQ(colours.ambient, (std::array<float, 4>{1, 1, 1, 1}));
  EXPECT_EQ(colours.diffuse, (std::array<float, 4>{0, 0, 0, 1}));
  EXPECT_EQ(colours.specular, (std::array<float, 4>{0, 0, 0, 1}));
  Light215 numbers;
  makeEven(numbers);
  EXPECT_EQ(numbers.ambient, 1);
  EXPECT_EQ(numbers.diffuse, 0);
  EXPECT_EQ(numbers.specular, 0);
  Light3 lamps;
  makeEven(lamps);
  EXPECT_EQ(lamps.ambient, 1);
  EXPECT_TRUE(lamps.lights.empty());
}

// What renders, as it takes its camera in different versions.
struct Renderer25 {
  const viz::CCamera* camera = nullptr;
  void setCamera(const MrptScene&, const viz::CCamera& given) { camera = &given; }
};
struct Renderer3 {
  const viz::CCamera* camera = nullptr;
  void setCamera(const viz::CCamera& given) { camera = &given; }
};

TEST(MrptCompat, aSceneIsSeenByItsOwnCameraInEveryVersion) {
  const auto scene = MrptScene::Create();
  Renderer25 asks;
  useCameraOf(*scene, asks);
  EXPECT_EQ(asks.camera, &scene->getViewport()->getCamera());
  Renderer3 knows;
  useCameraOf(*scene, knows);
  EXPECT_EQ(knows.camera, nullptr);
}

// A viewport that tells the ray behind a pixel, as in different versions.
struct Viewport25 {
  void get3DRayForPixelCoord(double x, double y, mrpt::math::TLine3D& ray) const {
    ray.pBase = {x, y, 0};
  }
};
struct Pixel {
  int x, y;
};
struct Viewport3 {
  bool isDrawn = true;
  std::optional<mrpt::math::TLine3D> get3DRayForPixelCoord(const Pixel& pixel) const {
    mrpt::math::TLine3D ray;
    ray.pBase = {double(pixel.x), double(pixel.y), 0};
    return isDrawn ? std::optional<mrpt::math::TLine3D>(ray) : std::nullopt;
  }
};

TEST(MrptCompat, raysAreToldInEveryVersion) {
  Viewport25 fillsIn;
  EXPECT_EQ(rayThrough(fillsIn, 3, 4).value().pBase.y, 4);
  Viewport3 returns;
  EXPECT_EQ(rayThrough(returns, 3, 4).value().pBase.y, 4);
  returns.isDrawn = false;
  EXPECT_FALSE(rayThrough(returns, 3, 4).has_value());
}

}  // namespace
}  // namespace roomgraph
