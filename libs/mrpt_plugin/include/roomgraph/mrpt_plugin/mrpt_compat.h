#pragma once

// The only place that knows what changed between MRPT's versions: MRPT 3 moved the 3D objects from
// mrpt::opengl to mrpt::viz and calls the scene Scene and what is in it CVisualObject; a viewport's
// light has been colours, numbers, and a list of lamps; what renders takes the scene's own camera;
// a ray is returned where it was an argument.

#if __has_include(<mrpt/viz/Scene.h>)
#include <mrpt/viz/CDisk.h>
#include <mrpt/viz/CPointCloud.h>
#include <mrpt/viz/CSetOfLines.h>
#include <mrpt/viz/CSetOfObjects.h>
#include <mrpt/viz/CSetOfTriangles.h>
#include <mrpt/viz/CText3D.h>
#include <mrpt/viz/CTexturedPlane.h>
#include <mrpt/viz/Scene.h>
#include <mrpt/viz/Visualizable.h>
namespace roomgraph {
namespace viz = mrpt::viz;
using MrptScene = viz::Scene;
using MrptObject = viz::CVisualObject;
}  // namespace roomgraph
#else
#include <mrpt/opengl/CDisk.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CText3D.h>
#include <mrpt/opengl/CTexturedPlane.h>
#include <mrpt/opengl/Visualizable.h>
namespace roomgraph {
namespace viz = mrpt::opengl;
using MrptScene = viz::COpenGLScene;
using MrptObject = viz::CRenderizable;
}  // namespace roomgraph
#endif

#include <mrpt/core/Stringifyable.h>
#include <mrpt/math/TLine3D.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <optional>
#include <type_traits>

namespace roomgraph {

template <class Light, class = void>
struct HasLamps : std::false_type {};
template <class Light>
struct HasLamps<Light, std::void_t<decltype(std::declval<Light&>().lights)>> : std::true_type {};

/** Light from everywhere, in which a surface has its own colour, whichever way it faces. */
template <class Light>
void makeEven(Light& light) {
  if constexpr (HasLamps<Light>::value) {  // MRPT 3
    light.ambient = 1;
    light.lights.clear();
  } else if constexpr (std::is_arithmetic_v<decltype(light.ambient)>) {  // MRPT 2.10 to 2.15
    light.ambient = 1;
    light.diffuse = light.specular = 0;
  } else {
    light.ambient = {1, 1, 1, 1};
    light.diffuse = light.specular = {0, 0, 0, 1};
  }
}

template <class Viewport, class = void>
struct FillsInRay : std::false_type {};
template <class Viewport>
struct FillsInRay<Viewport, std::void_t<decltype(std::declval<Viewport&>().get3DRayForPixelCoord(
                                0.0, 0.0, std::declval<mrpt::math::TLine3D&>()))>>
    : std::true_type {};

/** What lies behind a pixel of the viewport; none where it has not been drawn. */
template <class Viewport>
[[nodiscard]] std::optional<mrpt::math::TLine3D> rayThrough(Viewport& viewport, double x,
                                                            double y) {
  if constexpr (FillsInRay<Viewport>::value) {
    mrpt::math::TLine3D ray;
    viewport.get3DRayForPixelCoord(x, y, ray);
    return ray;
  } else {  // MRPT 3
    return viewport.get3DRayForPixelCoord({int(x), int(y)});
  }
}

template <class Renderer, class = void>
struct AsksForCamera : std::false_type {};
template <class Renderer>
struct AsksForCamera<Renderer,
                     std::void_t<decltype(std::declval<Renderer&>().setCamera(
                         std::declval<const MrptScene&>(), std::declval<const viz::CCamera&>()))>>
    : std::true_type {};

/** Makes it see a scene as the camera of its viewport does. MRPT 3 does so by itself. */
template <class Renderer>
void useCameraOf(const MrptScene& scene, Renderer& renderer) {
  if constexpr (AsksForCamera<Renderer>::value)
    renderer.setCamera(scene, scene.getViewport()->getCamera());
}

}  // namespace roomgraph
